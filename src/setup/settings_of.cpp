#include "setup/settings_of.hpp"

#include <fmt/core.h>

#include <span>
#include <string_view>

#include "setup/parameter_table.hpp"

namespace moraine {
namespace {

template <class Target>
void add_settings(std::vector<Setting>& list, std::string const& section,
                  std::span<Entry<Target> const> entries, Target const& target, int dimension) {
  for (auto const& [parameter, set, get] : entries) {
    if (parameter.type == ValueType::shape_key) continue;
    std::string value = to_toml(get(target), parameter, dimension);
    if (value.empty()) continue;
    std::string_view key = parameter.key;
    std::string table = section;
    if (std::size_t const dot = key.find('.');
        parameter.section == Section::top && dot != std::string_view::npos) {
      table = key.substr(0, dot);
      key.remove_prefix(dot + 1);
    }
    bool const is_default = value == to_toml(parameter.preset, parameter, dimension);
    std::string unit;
    if (parameter.quantity != Quantity::number) unit = info(parameter.quantity).unit;
    list.push_back({std::move(table), std::string(key), std::move(value), std::move(unit),
                    is_default, std::string(parameter.meaning)});
  }
}

template <class Spec>
void add_list(std::vector<Setting>& list, std::string_view section,
              std::span<Entry<Spec> const> entries, std::vector<Spec> const& specs, int dimension) {
  for (Spec const& spec : specs)
    add_settings(list, fmt::format("{} {}", section, spec.name), entries, spec, dimension);
}

}  // namespace

std::vector<Setting> settings_of(Case const& c) {
  std::vector<Setting> list;
  add_settings(list, "", case_entries(), c, c.dimension);
  add_list(list, "material", material_entries(), c.materials, c.dimension);
  add_list(list, "region", region_entries(), c.regions, c.dimension);
  add_list(list, "wall", wall_entries(), c.walls, c.dimension);
  add_list(list, "gauge", gauge_entries(), c.gauges, c.dimension);
  add_list(list, "stage", stage_entries(), c.stages, c.dimension);
  add_list(list, "reference", reference_entries(), c.references, c.dimension);
  return list;
}

}  // namespace moraine
