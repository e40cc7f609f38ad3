#include "setup/json_schema.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "setup/parameter_table.hpp"
#include "setup/schema_table.hpp"
#include "setup/schema_value.hpp"
#include "setup/shape_table.hpp"

namespace moraine {
namespace {

using Json = nlohmann::ordered_json;
using Parameters = std::vector<Parameter const*>;

Parameters of_section(Section section) {
  Parameters result;
  for (auto const* parameter : all_parameters())
    if (parameter->section == section) result.push_back(parameter);
  return result;
}

Json section_schema(SectionInfo const& section) {
  Json const table = table_schema(of_section(section.section));
  Json schema{{"description", section.meaning}};
  if (section.repeat == Repeat::named) {
    schema["type"] = "object";
    schema["additionalProperties"] = table;
  } else {
    schema.update(list_schema(table));
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
    if (parameter->type == ValueType::vector) put_schema(table, parameter->key, length, false);
    if (parameter->type == ValueType::points)
      put_schema(table, parameter->key, Json{{"items", length}}, false);
    if (parameter->type == ValueType::shapes)
      put_schema(table, parameter->key,
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
    put_schema(table, section.key, Json{{items, std::move(rules)}}, false);
  }
  return table;
}

void add_vector_lengths(Json& schema) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    Json condition = Json::object();
    put_schema(condition, "space.dimension", Json{{"const", dimension}}, false);
    require_key(condition, "space.dimension", true);
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
  schema.update(table_schema(of_section(Section::top)));
  for (auto const& section : section_table) {
    if (section.repeat == Repeat::once) continue;
    put_schema(schema, section.key, section_schema(section), true);
    if (section.needed) require_key(schema, section.key, true);
  }
  Json regions = has_key("region");
  put_schema(regions, "region", Json{{"minItems", 1}}, false);
  schema["anyOf"] = Json::array({std::move(regions), has_key("start")});
  schema["$defs"]["shape"] = table_schema(of_shapes());
  add_vector_lengths(schema);
  return schema.dump(2) + '\n';
}

}  // namespace moraine
