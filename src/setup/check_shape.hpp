// What one shape must fulfil beyond its single values.
#pragma once

#include <string>
#include <string_view>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Checks and completes a shape whose keys begin with `key`; false if it cannot be used, then a
/// mistake has been reported.
bool check_shape(Shape& shape, std::string const& key, Case const& c, Source& source);

/// Whether a shape holds all that its bounds need; one with a mistake may not.
bool is_complete(Shape const& shape, int dimension);

/// The full key that says where a shape lies: "region.charge.disc.center".
std::string place_key(Shape const& shape, std::string const& key);

/// "disc", "prism", "body".
std::string_view word_for(Shape const& shape);

}  // namespace moraine
