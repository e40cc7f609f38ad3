#include "setup/schema_table.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "setup/parameter_text.hpp"
#include "setup/schema_value.hpp"

namespace moraine {

using Json = nlohmann::ordered_json;
using Parameters = std::vector<Parameter const*>;

namespace {

std::string_view first_part(std::string_view key) { return key.substr(0, key.find('.')); }

std::string_view rest_of(std::string_view key) {
  auto const dot = key.find('.');
  return dot == std::string_view::npos ? std::string_view{} : key.substr(dot + 1);
}

Json closed_table() {
  return Json{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
}

void require_one(Json& table, std::string_view name) {
  Json& list = table["required"];
  for (auto const& other : list)
    if (other == name) return;
  list.push_back(name);
}

}  // namespace

void put_schema(Json& table, std::string_view key, Json schema, bool closed) {
  Json& place = table["properties"][std::string(first_part(key))];
  if (rest_of(key).empty()) {
    place = std::move(schema);
    return;
  }
  if (place.is_null()) place = closed ? closed_table() : Json::object();
  put_schema(place, rest_of(key), std::move(schema), closed);
}

void require_key(Json& table, std::string_view key, bool with_parents) {
  bool const leaf = rest_of(key).empty();
  if (leaf || with_parents) require_one(table, first_part(key));
  if (!leaf)
    require_key(table["properties"][std::string(first_part(key))], rest_of(key), with_parents);
}

Json has_key(std::string_view key) {
  Json schema = Json::object();
  require_key(schema, key, true);
  return schema;
}

namespace {

void require(Json& table, Parameter const& parameter) {
  if (parameter.presence != Presence::optional)
    require_key(table, parameter.key, parameter.presence == Presence::required);
}

// The schema of one table, from those parameters of the list that belong to its section.
class TableSchema {
 public:
  explicit TableSchema(Parameters parameters) : parameters_(std::move(parameters)) {}

  Json build() const {
    Json table = closed_table();
    for (auto const* parameter : parameters_) {
      if (parameter->type != ValueType::shape_key)
        put_schema(table, parameter->key, leaf(*parameter), true);
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
    if (all.size() == 1) return described_value(parameter);
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
    put_schema(schema, choice.key, Json{{"const", name}}, false);
    bool const preset = choice.preset == Value(static_cast<int>(index));
    if (!preset) require_key(schema, choice.key, true);
    return schema;
  }

  // What follows from the choice `key` = `name`: keys that must be there, keys that must not.
  Json consequences(std::string_view key, std::string_view name, bool values_known) const {
    Json rules = Json::object();
    for (auto const* parameter : parameters_) {
      if (parameter->when_key != key) continue;
      auto const all = variants(parameter->key);
      if (parameter->when_value == name) {
        if (all.size() > 1) put_schema(rules, parameter->key, described_value(*parameter), false);
        continue;
      }
      bool possible = false;
      for (auto const* one : all)
        possible = possible || one->when_key != key || one->when_value == name;
      if (!possible) put_schema(rules, parameter->key, Json(false), false);
    }
    if (values_known) return rules;
    for (auto const* parameter : parameters_)
      if (parameter->when_key == key && parameter->when_value == name) require(rules, *parameter);
    return rules;
  }

  Parameters parameters_;
};

}  // namespace

Json table_schema(Parameters parameters) { return TableSchema(std::move(parameters)).build(); }

}  // namespace moraine
