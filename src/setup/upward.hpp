// Which way is up for gauges that measure heights.
#pragma once

#include <optional>

#include "setup/case.hpp"

namespace moraine {

/// The side of the domain [2 axis + (0 minus | 1 plus)] that lies above: the one that is given, or
/// against gravity, or without gravity the plus side of the last axis. None where gravity points
/// along no axis and no side is given.
std::optional<int> side_above(Case const& c, std::optional<int> const& given);

}  // namespace moraine
