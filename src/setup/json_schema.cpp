#include "setup/json_schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "setup/parameter_table.hpp"
#include "setup/parameter_text.hpp"
#include "setup/shape_table.hpp"

namespace moraine {
namespace {

using Json = nlohmann::ordered_json;
using Parameters = std::vector<Parameter const*>;

// A number and its unit, as to_si() reads them. A plain number may stand alone.
std::string number_pattern(Quantity quantity) {
  std::string const number = R"(^[ \t]*\+?-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?[ \t]*)";
  return quantity == Quantity::number ? number : number + R"(([^ \t0-9.]|1/))";
}

Json number_schema(Parameter const& parameter) {
  Json number{{"type", parameter.type == ValueType::integer ? "integer" : "number"}};
  auto const& limits = parameter.limits;
  if (std::isfinite(limits.min))
    number[limits.min_excluded ? "exclusiveMinimum" : "minimum"] = limits.min;
  if (std::isfinite(limits.max)) number["maximum"] = limits.max;
  if (parameter.type == ValueType::integer) return number;
  Json const text{{"type", "string"}, {"pattern", number_pattern(parameter.quantity)}};
  return Json{{"anyOf", Json::array({number, text})}};
}

template <class Names>
Json name_schema(Names const& names) {
  Json list = Json::array();
  for (std::string_view const name : names) list.push_back(name);
  return Json{{"enum", list}};
}

Json list_of(Json items) { return Json{{"type", "array"}, {"items", std::move(items)}}; }

Json vector_schema(Parameter const& parameter) {
  Json list = list_of(number_schema(parameter));
  list["minItems"] = 1;
  list["maxItems"] = 3;
  return list;
}

Json value_schema(Parameter const& parameter) {
  switch (parameter.type) {
    case ValueType::integer:
    case ValueType::real:
      return number_schema(parameter);
    case ValueType::reals:
      return list_of(number_schema(parameter));
    case ValueType::vector:
      return vector_schema(parameter);
    case ValueType::text:
      return Json{{"type", "string"}, {"minLength", 1}};
    case ValueType::choice:
      return name_schema(parameter.names);
    case ValueType::axes:
      return list_of(name_schema(axis_names));
    case ValueType::side:
      return name_schema(side_names);
    case ValueType::sides:
      return list_of(name_schema(side_names));
    case ValueType::texts:
      if (!parameter.names.empty()) return list_of(name_schema(parameter.names));
      return list_of(Json{{"type", "string"}, {"minLength", 1}});
    case ValueType::corners: {
      Json corner = list_of(number_schema(parameter));
      corner["minItems"] = 2;
      corner["maxItems"] = 2;
      return list_of(std::move(corner));
    }
    case ValueType::points:
      return list_of(vector_schema(parameter));
    case ValueType::shapes:
      return list_of(Json{{"$ref", "#/$defs/shape"}});
    case ValueType::shape_key:
      break;
  }
  return Json(true);
}

// A value of TOML that is valid JSON too, as all are but those that are not finite.
Json json_of(std::string const& toml) {
  Json value = Json::parse(toml, nullptr, false);
  return value.is_discarded() ? Json() : value;
}

Json described(Parameter const& parameter) {
  Json schema{{"description",
               fmt::format("{}. Unit: {}. Default: {}. Valid: {}.", parameter.meaning,
                           unit_text(parameter), default_text(parameter), range_text(parameter))}};
  schema.update(value_schema(parameter));
  if (parameter.type != ValueType::vector)
    if (Json preset = json_of(to_toml(parameter.preset, parameter, 3)); !preset.is_null())
      schema["default"] = std::move(preset);
  if (Json example = json_of(example_value(parameter)); !example.is_null())
    schema["examples"] = Json::array({std::move(example)});
  return schema;
}

std::string_view first_part(std::string_view key) { return key.substr(0, key.find('.')); }

std::string_view rest_of(std::string_view key) {
  auto const dot = key.find('.');
  return dot == std::string_view::npos ? std::string_view{} : key.substr(dot + 1);
}

Json closed_table() {
  return Json{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
}

// Puts a schema at a dotted key. Tables on the way are closed unless they only add conditions.
void put(Json& table, std::string_view key, Json schema, bool closed) {
  Json& place = table["properties"][std::string(first_part(key))];
  if (rest_of(key).empty()) {
    place = std::move(schema);
    return;
  }
  if (place.is_null()) place = closed ? closed_table() : Json::object();
  put(place, rest_of(key), std::move(schema), closed);
}

void require_one(Json& table, std::string_view name) {
  Json& list = table["required"];
  for (auto const& other : list)
    if (other == name) return;
  list.push_back(name);
}

void require(Json& table, std::string_view key, bool with_parents) {
  bool const leaf = rest_of(key).empty();
  if (leaf || with_parents) require_one(table, first_part(key));
  if (!leaf) require(table["properties"][std::string(first_part(key))], rest_of(key), with_parents);
}

void require(Json& table, Parameter const& parameter) {
  if (parameter.presence != Presence::optional)
    require(table, parameter.key, parameter.presence == Presence::required);
}

Json has_key(std::string_view key) {
  Json schema = Json::object();
  require(schema, key, true);
  return schema;
}

// The schema of one table, from those parameters of the list that belong to its section.
class TableSchema {
 public:
  explicit TableSchema(Parameters parameters) : parameters_(std::move(parameters)) {}

  Json build() const {
    Json table = closed_table();
    for (auto const* parameter : parameters_) {
      if (parameter->type != ValueType::shape_key)
        put(table, parameter->key, leaf(*parameter), true);
    }
    for (auto const* parameter : parameters_) {
      if (parameter->type == ValueType::shape_key || is_decided(*parameter)) continue;
      if (parameter->when_key.empty()) require(table, *parameter);
    }
    for (auto const* choice : parameters_) add_conditions(table, *choice);
    for (auto const* parameter : parameters_)
      if (!parameter->unless_key.empty())
        table["anyOf"] = Json::array({has_key(parameter->key), has_key(parameter->unless_key)});
    return table;
  }

 private:
  Parameters variants(std::string_view key) const {
    Parameters result;
    for (auto const* parameter : parameters_)
      if (parameter->key == key) result.push_back(parameter);
    return result;
  }

  // What can be said of a key without knowing the choices: all of it if there is one meaning.
  Json leaf(Parameter const& parameter) const {
    auto const all = variants(parameter.key);
    if (all.size() == 1) return described(parameter);
    std::string text;
    for (auto const* one : all)
      text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", condition_text(*one), one->meaning);
    return Json{{"description", text}};
  }

  bool is_decided(Parameter const& parameter) const {
    for (auto const* other : parameters_)
      if (other->decides == parameter.key) return true;
    return false;
  }

  void add_conditions(Json& table, Parameter const& choice) const {
    if (choice.type == ValueType::shape_key) {
      Json alternatives = Json::array();
      for (auto const name : choice.names) alternatives.push_back(has_key(name));
      table["allOf"].push_back(Json{{"oneOf", std::move(alternatives)}});
    }
    if (!choice.decides.empty())
      table["allOf"].push_back(
          Json{{"oneOf", Json::array({has_key(choice.key), has_key(choice.decides)})}});
    for (std::size_t i = 0; i < choice.names.size(); ++i) {
      bool const decided = !choice.decides.empty();
      auto const key = decided ? choice.decides : choice.key;
      Json rules = consequences(key, decided ? choice.decided[i] : choice.names[i], decided);
      if (!rules.empty())
        table["allOf"].push_back(
            Json{{"if", condition(choice, choice.names[i], i)}, {"then", std::move(rules)}});
    }
  }

  static Json condition(Parameter const& choice, std::string_view name, std::size_t index) {
    if (choice.type == ValueType::shape_key) return has_key(name);
    Json schema = Json::object();
    put(schema, choice.key, Json{{"const", name}}, false);
    bool const preset = choice.preset == Value(static_cast<int>(index));
    if (!preset) require(schema, choice.key, true);
    return schema;
  }

  // What follows from the choice `key` = `name`: keys that must be there, keys that must not.
  Json consequences(std::string_view key, std::string_view name, bool values_known) const {
    Json rules = Json::object();
    for (auto const* parameter : parameters_) {
      if (parameter->when_key != key) continue;
      auto const all = variants(parameter->key);
      if (parameter->when_value == name) {
        if (all.size() > 1) put(rules, parameter->key, described(*parameter), false);
        continue;
      }
      bool possible = false;
      for (auto const* one : all)
        possible = possible || one->when_key != key || one->when_value == name;
      if (!possible) put(rules, parameter->key, Json(false), false);
    }
    if (values_known) return rules;
    for (auto const* parameter : parameters_)
      if (parameter->when_key == key && parameter->when_value == name) require(rules, *parameter);
    return rules;
  }

  Parameters parameters_;
};

Parameters of_section(Section section) {
  Parameters result;
  for (auto const* parameter : all_parameters())
    if (parameter->section == section) result.push_back(parameter);
  return result;
}

Json section_schema(SectionInfo const& section) {
  Json const table = TableSchema(of_section(section.section)).build();
  Json schema{{"description", section.meaning}};
  if (section.repeat == Repeat::named) {
    schema["type"] = "object";
    schema["additionalProperties"] = table;
  } else {
    schema.update(list_of(table));
  }
  if (section.needed) schema[section.repeat == Repeat::named ? "minProperties" : "minItems"] = 1;
  return schema;
}

Parameters of_shapes() {
  Parameters result;
  for (auto const& entry : shape_entries()) result.push_back(&entry.parameter);
  return result;
}

std::string lengths_of_shapes(int dimension) {
  return fmt::format("vectors_of_shapes_in_{}d", dimension);
}

// What the dimension says about a table: vectors have as many components.
Json vector_lengths(Parameters const& parameters, int dimension) {
  Json table = Json::object();
  for (auto const* parameter : parameters) {
    Json const length{{"minItems", dimension}, {"maxItems", dimension}};
    if (parameter->type == ValueType::vector) put(table, parameter->key, length, false);
    if (parameter->type == ValueType::points)
      put(table, parameter->key, Json{{"items", length}}, false);
    if (parameter->type == ValueType::shapes)
      put(table, parameter->key,
          Json{{"items", Json{{"$ref", "#/$defs/" + lengths_of_shapes(dimension)}}}}, false);
  }
  return table;
}

Json vector_lengths(int dimension) {
  Json table = vector_lengths(of_section(Section::top), dimension);
  for (auto const& section : section_table) {
    if (section.repeat == Repeat::once) continue;
    Json rules = vector_lengths(of_section(section.section), dimension);
    if (rules.empty()) continue;
    char const* const items = section.repeat == Repeat::named ? "additionalProperties" : "items";
    put(table, section.key, Json{{items, std::move(rules)}}, false);
  }
  return table;
}

void add_vector_lengths(Json& schema) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    Json condition = Json::object();
    put(condition, "space.dimension", Json{{"const", dimension}}, false);
    require(condition, "space.dimension", true);
    schema["allOf"].push_back(
        Json{{"if", std::move(condition)}, {"then", vector_lengths(dimension)}});
    schema["$defs"][lengths_of_shapes(dimension)] = vector_lengths(of_shapes(), dimension);
  }
}

}  // namespace

std::string json_schema() {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Moraine case"},
              {"description",
               "A case of the particle solver Moraine. Numbers are in SI units; a text carries its "
               "unit, such as \"4 cm\"."}};
  schema.update(TableSchema(of_section(Section::top)).build());
  for (auto const& section : section_table) {
    if (section.repeat == Repeat::once) continue;
    put(schema, section.key, section_schema(section), true);
    if (section.needed) require(schema, section.key, true);
  }
  Json regions = has_key("region");
  put(regions, "region", Json{{"minItems", 1}}, false);
  schema["anyOf"] = Json::array({std::move(regions), has_key("start")});
  schema["$defs"]["shape"] = TableSchema(of_shapes()).build();
  add_vector_lengths(schema);
  return schema.dump(2) + '\n';
}

}  // namespace moraine
