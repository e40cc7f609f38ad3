// What is said to users about a parameter, the same in `explain`, the schema and the reference
// page.
#pragma once

#include <string>

#include "setup/parameter.hpp"

namespace moraine {

/// "m (also \"cm\", \"mm\", \"km\")", or "-" where the value has no unit.
std::string unit_text(Parameter const& parameter);

/// The default as TOML with its unit, or how it is found, or that the key must be given.
std::string default_text(Parameter const& parameter);

/// The valid values in words: a range, the names, the number of components.
std::string range_text(Parameter const& parameter);

/// A valid value as TOML, "\"1 cm\"" for a length; empty for a shape key, which has no value.
std::string example_value(Parameter const& parameter);

/// The condition under which the key exists, "eos = \"tait\"" or "a box"; empty: always.
std::string condition_text(Parameter const& parameter);

}  // namespace moraine
