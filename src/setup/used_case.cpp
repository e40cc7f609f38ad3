#include "setup/used_case.hpp"

#include <fmt/core.h>

#include <string_view>
#include <type_traits>

#include "setup/parameter_table.hpp"
#include "setup/shape_table.hpp"

namespace moraine {
namespace {

// A name that is no bare TOML key must be quoted.
std::string header_key(std::string const& name) {
  bool const bare =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
      std::string::npos;
  return bare && !name.empty() ? name : to_toml(name, Parameter{}, 0);
}

std::string comment(Parameter const& parameter) {
  if (parameter.quantity == Quantity::number) return {};
  return fmt::format("  # {}", info(parameter.quantity).unit);
}

// The keys of one table. At the top, "time.end" goes below a header [time].
template <class Target>
std::string table_text(std::span<Entry<Target> const> entries, Target const& target,
                       int dimension) {
  std::string text;
  std::string_view header;
  for (auto const& [parameter, set, get] : entries) {
    if (parameter.type == ValueType::shape_key) continue;
    std::string const value = to_toml(get(target), parameter, dimension);
    if (value.empty()) continue;
    std::string_view key = parameter.key;
    if (parameter.section == Section::top && key.find('.') != std::string_view::npos) {
      auto const first = key.substr(0, key.find('.'));
      if (first != header) text += fmt::format("\n[{}]\n", first);
      header = first;
      key.remove_prefix(first.size() + 1);
    }
    text += fmt::format("{} = {}{}\n", key, value, comment(parameter));
  }
  return text;
}

template <class Spec>
std::string list_text(std::string_view section, std::span<Entry<Spec> const> entries,
                      std::vector<Spec> const& specs, int dimension) {
  std::string text;
  for (auto const& spec : specs) {
    text += fmt::format("\n[[{}]]\n{}", section, table_text(entries, spec, dimension));
    if constexpr (std::is_same_v<Spec, RegionSpec>) text += shape_lists_text(spec, dimension);
  }
  return text;
}

}  // namespace

std::string material_constants(Case const& c, MaterialSpec const& material) {
  return table_text(material_entries(), material, c.dimension);
}

std::string used_case(Case const& c) {
  std::string text = table_text(case_entries(), c, c.dimension);
  for (auto const& material : c.materials)
    text += fmt::format("\n[material.{}]\n{}", header_key(material.name),
                        material_constants(c, material));
  text += list_text("region", region_entries(), c.regions, c.dimension);
  text += list_text("wall", wall_entries(), c.walls, c.dimension);
  text += list_text("gauge", gauge_entries(), c.gauges, c.dimension);
  text += list_text("stage", stage_entries(), c.stages, c.dimension);
  text += list_text("reference", reference_entries(), c.references, c.dimension);
  return text;
}

}  // namespace moraine
