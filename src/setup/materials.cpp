#include "setup/materials.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/input_error.hpp"
#include "setup/check_strength.hpp"
#include "setup/parameter_table.hpp"
#include "setup/source.hpp"
#include "setup/toml.hpp"
#include "setup/value_reader.hpp"

namespace moraine {
namespace {

struct ReferenceKind {
  std::string_view key;
  Quantity quantity;
};
constexpr std::array<ReferenceKind, 4> reference_kinds{{
    {"pressure", Quantity::pressure},
    {"sound_speed", Quantity::velocity},
    {"detonation_velocity", Quantity::velocity},
    {"detonation_pressure", Quantity::pressure},
}};

class MaterialReader {
 public:
  MaterialReader(std::string_view text, std::string_view name)
      : table_(toml::parse(text, file_of(name))), source_(text, file_of(name)) {
    material_.spec.name = name;
  }

  ShippedMaterial read() {
    material_.meaning = text_at(table_, "meaning", "");
    read_law();
    read_tension();
    read_strength();
    for (auto const& [key, node] : table_)
      if (!known(key.str()))
        source_.report_key(std::string(key.str()), stretch_of(key.source()), "is an unknown key");
    if (auto const* references = table_["reference"].as_table()) read_references(*references);
    if (!source_.problems().empty()) throw InputErrors(source_.problems());
    return std::move(material_);
  }

 private:
  static std::string file_of(std::string_view name) {
    return fmt::format("materials/{}.toml", name);
  }

  std::string text_at(toml::table const& table, std::string_view key, std::string const& prefix) {
    std::string text = table[key].value_or(std::string{});
    if (text.empty())
      source_.report_key(fmt::format("{}{}", prefix, key), stretch_of(table.source()),
                         "is missing: a text");
    return text;
  }

  /// Sets a choice by its name, or reports the name with the rule that it breaks.
  void choose(Entry<MaterialSpec> const& entry, std::string const& name, Stretch place,
              std::string rule) {
    auto const& names = entry.parameter.names;
    auto const found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      source_.report_key(std::string(entry.parameter.key), place, std::move(rule),
                         name_hint(name, names));
    else
      entry.set(material_.spec, static_cast<int>(found - names.begin()));
  }

  void read_law() {
    std::string const law = text_at(table_, "eos", "");
    for (auto const& entry : material_entries()) {
      auto const& [parameter, set, get] = entry;
      if (parameter.key == "eos") choose(entry, law, {}, "is no equation of state");
      if (parameter.when_key != "eos" || parameter.when_value != law) continue;
      constants_.emplace_back(parameter.key);
      if (auto const value = value_at(table_, std::string(parameter.key), parameter, ""))
        set(material_.spec, *value);
    }
  }

  /// What becomes of it in tension; may be missing.
  void read_tension() {
    auto const* node = table_.get("tension");
    if (node == nullptr) return;
    for (auto const& entry : material_entries())
      if (entry.parameter.key == "tension")
        choose(entry, text_at(table_, "tension", ""), stretch_of(node->source()),
               "is no end in tension");
  }

  /// [strength] with its kind and a table for each of its constants.
  void read_strength() {
    auto const* table = table_["strength"].as_table();
    if (table == nullptr) return;
    constexpr std::string_view prefix = "strength.";
    std::vector<std::string> known;
    for (auto const& entry : material_entries()) {
      auto const& [parameter, set, get] = entry;
      if (!parameter.key.starts_with(prefix)) continue;
      std::string const key(parameter.key.substr(prefix.size()));
      known.push_back(key);
      if (key == "kind") {
        choose(entry, text_at(*table, key, std::string(prefix)), {}, "is no strength");
      } else if (table->contains(key)) {
        if (auto const value = value_at(*table, key, parameter, std::string(prefix)))
          set(material_.spec, *value);
      }
    }
    for (auto const& [key, node] : *table)
      if (std::find(known.begin(), known.end(), key.str()) == known.end())
        source_.report_key(fmt::format("{}{}", prefix, key.str()), stretch_of(key.source()),
                           "is an unknown key");
    check_strength(material_.spec, "", source_);
  }

  // The value of a table { value, source }, noted for those who ask for sources.
  std::optional<Value> value_at(toml::table const& parent, std::string const& key,
                                Parameter const& parameter, std::string const& prefix) {
    auto const* table = parent[key].as_table();
    toml::node const* node = table != nullptr ? table->get("value") : nullptr;
    if (node == nullptr) {
      source_.report_key(prefix + key, stretch_of(parent.source()),
                         "is missing: a table with value");
      return std::nullopt;
    }
    std::string const full = prefix + key + ".value";
    if (parameter.quantity != Quantity::number && !node->is_string()) {
      source_.report_value(full, stretch_of(node->source()), "needs a unit");
      return std::nullopt;
    }
    std::string const text =
        node->is_string() ? *node->value<std::string>() : fmt::format("{}", node->value_or(0.0));
    material_.values.push_back({prefix == "reference." ? key : prefix + key, text,
                                text_at(*table, "source", prefix + key + '.')});
    return read_value(*node, parameter, 0, full, source_);
  }

  void read_references(toml::table const& references) {
    for (auto const& [key, quantity] : reference_kinds) {
      auto const* table = references[key].as_table();
      if (table == nullptr) continue;
      Parameter const parameter{.key = key, .quantity = quantity};
      auto const value = value_at(references, std::string(key), parameter, "reference.");
      MaterialValue const noted = material_.values.back();
      material_.values.pop_back();  // it is no constant
      double const tolerance = (*table)["tolerance"].value_or(-1.0);
      if (!(tolerance > 0.0))
        source_.report_key(fmt::format("reference.{}.tolerance", key), stretch_of(table->source()),
                           "is missing: a positive number");
      if (value)
        material_.references.push_back(
            {std::string(key), std::get<double>(*value), tolerance, noted.text, noted.source});
    }
  }

  bool known(std::string_view key) const {
    return key == "meaning" || key == "eos" || key == "tension" || key == "strength" ||
           key == "reference" ||
           std::find(constants_.begin(), constants_.end(), key) != constants_.end();
  }

  toml::table table_;
  Source source_;
  ShippedMaterial material_;
  std::vector<std::string> constants_;
};

std::vector<ShippedMaterial> read_all() {
  std::vector<ShippedMaterial> all;
  for (auto const& [name, text] : material_texts()) all.push_back(parse_material(text, name));
  return all;
}

}  // namespace

ShippedMaterial parse_material(std::string_view text, std::string_view name) {
  return MaterialReader(text, name).read();
}

std::span<ShippedMaterial const> shipped_materials() {
  static std::vector<ShippedMaterial> const all = read_all();
  return all;
}

ShippedMaterial const& shipped_material(std::string_view name) {
  std::vector<std::string_view> names;
  for (auto const& material : shipped_materials()) {
    if (material.spec.name == name) return material;
    names.push_back(material.spec.name);
  }
  throw InputErrors({{.file = "moraine materials",
                      .line = 0,
                      .column = 0,
                      .key = "",
                      .value = fmt::format("\"{}\"", name),
                      .rule = "is no shipped material",
                      .hint = name_hint(name, names)}});
}

std::string list_materials() {
  std::string text;
  for (auto const& material : shipped_materials())
    text += fmt::format("{:<18}{:<18}{}\n", material.spec.name, eos_name(material.spec.eos),
                        material.meaning);
  return text;
}

std::string describe(ShippedMaterial const& material) {
  std::string text = fmt::format("{}: {}\neos = \"{}\"\n", material.spec.name, material.meaning,
                                 eos_name(material.spec.eos));
  if (material.spec.strength.kind != StrengthKind::none)
    text += fmt::format("strength.kind = \"{}\"\n",
                        strength_names[static_cast<std::size_t>(material.spec.strength.kind)]);
  if (material.spec.tension == TensionEnd::spall) text += "tension = \"spall\"\n";
  for (auto const& value : material.values)
    text += fmt::format("  {:<26}{:<18}{}\n", value.key, value.text, value.source);
  if (!material.references.empty()) text += "compared with\n";
  for (auto const& reference : material.references)
    text += fmt::format("  {:<26}{:<18}{}\n", reference.key, reference.text, reference.source);
  return text;
}

}  // namespace moraine
