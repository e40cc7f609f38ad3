#include "setup/read_case.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/input_error.hpp"
#include "setup/check_case.hpp"
#include "setup/parameter_table.hpp"
#include "setup/shape_table.hpp"
#include "setup/table_reader.hpp"
#include "setup/toml.hpp"
#include "setup/value_reader.hpp"

namespace moraine {
namespace {

constexpr std::array<std::string_view, section_count - 1> section_keys{
    "material", "region", "wall", "gauge", "stage", "reference"};

toml::table parse_toml(std::string_view text, std::string_view file) {
  try {
    return toml::parse(text, file);
  } catch (toml::parse_error const& error) {
    auto const place = error.source().begin;
    throw InputErrors({{.file = std::string(file),
                        .line = place.line,
                        .column = place.column,
                        .key = "",
                        .value = "",
                        .rule = std::string(error.description()),
                        .hint = ""}});
  }
}

class CaseReader {
 public:
  CaseReader(std::string_view text, std::string_view file)
      : root_(parse_toml(text, file)), source_(text, file) {
    case_.file = file;
  }

  Case read() {
    case_.dimension = 0;  // not known yet
    read_table(TableReader(root_, "", source_), case_entries(), case_, case_.dimension,
               section_keys);
    read_materials();
    keys_.regions = read_list("region", region_entries(), case_.regions);
    keys_.walls = read_list("wall", wall_entries(), case_.walls);
    keys_.gauges = read_list("gauge", gauge_entries(), case_.gauges);
    keys_.stages = read_list("stage", stage_entries(), case_.stages);
    keys_.references = read_list("reference", reference_entries(), case_.references);
    finish_case(case_, keys_, source_);
    if (!source_.problems().empty()) throw InputErrors(source_.problems());
    case_.places = source_.places();
    return std::move(case_);
  }

 private:
  // In the order of the file: toml::table sorts by name, but ids of materials follow the file.
  void read_materials() {
    auto const* node = root_.get("material");
    if (node == nullptr) return;
    auto const* tables = node->as_table();
    if (tables == nullptr) return wrong_section("material", *node, "write [material.NAME]");
    std::vector<std::pair<toml::key const*, toml::node const*>> sorted;
    for (auto const& [key, value] : *tables) sorted.emplace_back(&key, &value);
    std::sort(sorted.begin(), sorted.end(), [](auto const& a, auto const& b) {
      auto const place_a = a.first->source().begin;
      auto const place_b = b.first->source().begin;
      return std::pair(place_a.line, place_a.column) < std::pair(place_b.line, place_b.column);
    });
    for (auto const& [key, value] : sorted) {
      std::string const full = "material." + std::string(key->str());
      auto const* table = value->as_table();
      if (table == nullptr) {
        wrong_section(full, *value, "write [material.NAME]");
        continue;
      }
      auto& material = case_.materials.emplace_back();
      material.name = key->str();
      read_table(TableReader(*table, full + '.', source_), material_entries(), material,
                 case_.dimension);
    }
  }

  // Returns the full keys of the items: by name if that is there and new, else by number.
  template <class Spec>
  std::vector<std::string> read_list(std::string_view section, std::span<Entry<Spec> const> entries,
                                     std::vector<Spec>& specs) {
    std::vector<std::string> keys;
    auto const* node = root_.get(section);
    if (node == nullptr) return keys;
    auto const* list = node->as_array();
    if (list == nullptr) {
      wrong_section(std::string(section), *node, fmt::format("write [[{}]]", section));
      return keys;
    }
    std::set<std::string> names;
    for (auto const& item : *list) {
      auto const* table = item.as_table();
      std::string full = fmt::format("{}[{}]", section, keys.size() + 1);
      if (table == nullptr) {
        wrong_section(full, item, fmt::format("write [[{}]]", section));
        continue;
      }
      std::string const name = (*table)["name"].value_or(std::string{});
      if (!name.empty() && names.insert(name).second) full = fmt::format("{}.{}", section, name);
      source_.remember(full, stretch_of(table->source()));
      Spec& spec = specs.emplace_back();
      read_table(TableReader(*table, full + '.', source_), entries, spec, case_.dimension);
      if constexpr (std::is_same_v<Spec, RegionSpec>)
        read_shape_lists(*table, full + '.', spec, case_.dimension, source_);
      keys.push_back(full);
    }
    return keys;
  }

  void wrong_section(std::string const& key, toml::node const& node, std::string hint) {
    source_.report_key(key, stretch_of(node.source()), "is not a table of this kind",
                       std::move(hint));
  }

  toml::table root_;
  Source source_;
  Case case_;
  ItemKeys keys_;
};

}  // namespace

Case parse_case(std::string_view text, std::string_view file_name) {
  return CaseReader(text, file_name).read();
}

Case read_case(std::filesystem::path const& path) {
  auto const refuse = [&](std::string rule, std::string hint = {}) {
    throw InputErrors({{path.string(), 0, 0, "", "", std::move(rule), std::move(hint)}});
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    auto const inside = path / "case.toml";
    bool const meant = std::filesystem::exists(inside, ignored);
    refuse("is a folder, not a case file",
           meant ? fmt::format("did you mean \"{}\"?", inside.string()) : "");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    refuse(errno == ENOENT ? "does not exist"
                           : fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string const text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return parse_case(text, path.string());
}

}  // namespace moraine
