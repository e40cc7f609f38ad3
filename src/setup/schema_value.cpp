#include "setup/schema_value.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "setup/parameter_text.hpp"

namespace moraine {

using Json = nlohmann::ordered_json;

Json list_schema(Json items) { return Json{{"type", "array"}, {"items", std::move(items)}}; }

namespace {

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

Json vector_schema(Parameter const& parameter) {
  Json list = list_schema(number_schema(parameter));
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
      return list_schema(number_schema(parameter));
    case ValueType::vector:
      return vector_schema(parameter);
    case ValueType::text:
      return Json{{"type", "string"}, {"minLength", 1}};
    case ValueType::choice:
      return name_schema(parameter.names);
    case ValueType::axes:
      return list_schema(name_schema(axis_names));
    case ValueType::side:
      return name_schema(side_names);
    case ValueType::sides:
      return list_schema(name_schema(side_names));
    case ValueType::texts:
      if (!parameter.names.empty()) return list_schema(name_schema(parameter.names));
      return list_schema(Json{{"type", "string"}, {"minLength", 1}});
    case ValueType::corners: {
      Json corner = list_schema(number_schema(parameter));
      corner["minItems"] = 2;
      corner["maxItems"] = 2;
      return list_schema(std::move(corner));
    }
    case ValueType::points:
      return list_schema(vector_schema(parameter));
    case ValueType::shapes:
      return list_schema(Json{{"$ref", "#/$defs/shape"}});
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

}  // namespace

Json described_value(Parameter const& parameter) {
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

}  // namespace moraine
