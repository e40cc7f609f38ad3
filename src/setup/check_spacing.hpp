// Checks of regions with lattices of their own.
#pragma once

#include <string>
#include <vector>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports regions whose spacing cannot be found (both ways given, no such region, in a circle, no
/// single material), does not suit the smoothing length of the case, or does not divide the period
/// of a periodic domain that they fill. `keys` are the full keys of the regions.
void check_spacings(Case const& c, std::vector<std::string> const& keys, Source& source);

}  // namespace moraine
