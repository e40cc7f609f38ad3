// What JSON Schema says about one value of a case file.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "setup/parameter.hpp"

namespace moraine {

/// Type, limits and valid names of a value, with what people want to know of it: meaning, unit,
/// default, range and an example.
nlohmann::ordered_json described_value(Parameter const& parameter);

/// A list of values that all obey one schema.
nlohmann::ordered_json list_schema(nlohmann::ordered_json items);

}  // namespace moraine
