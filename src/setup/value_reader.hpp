// From a TOML value to a Value in SI, by what the table says about the parameter.
#pragma once

#include <optional>
#include <string>

#include "setup/parameter.hpp"
#include "setup/source.hpp"
#include "setup/toml.hpp"

namespace moraine {

/// Where a node or key of the file stands.
Stretch stretch_of(toml::source_region const& region);

/// Reads and checks one value: type, unit, number of components, names, range. Mistakes are
/// reported under `key`; then there is no value. `dimension` 0 means that it is not known.
std::optional<Value> read_value(toml::node const& node, Parameter const& parameter, int dimension,
                                std::string const& key, Source& source);

}  // namespace moraine
