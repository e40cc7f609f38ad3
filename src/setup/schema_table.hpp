// What JSON Schema says about a table of a case file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "setup/parameter.hpp"

namespace moraine {

/// Puts a schema at a dotted key of a table. Tables on the way are closed, unless they only add
/// conditions.
void put_schema(nlohmann::ordered_json& table, std::string_view key, nlohmann::ordered_json schema,
                bool closed);

/// Demands a dotted key, and with `with_parents` the tables on the way too.
void require_key(nlohmann::ordered_json& table, std::string_view key, bool with_parents);

/// A table that has this key.
nlohmann::ordered_json has_key(std::string_view key);

/// The schema of a table of these parameters: which keys are possible, which must be there, and
/// what follows from choices.
nlohmann::ordered_json table_schema(std::vector<Parameter const*> parameters);

}  // namespace moraine
