// What a case has in space beside its particles: walls and places of gauges, for the player.
#pragma once

#include <string>

#include "report/blocks.hpp"
#include "setup/case.hpp"

namespace moraine::report {

/// The boxes of the walls that stay where the case puts them, as a list of the type WallBox. Walls
/// that push or mirror have no particles of their own, so that nothing else shows where they are.
Json wall_boxes_of(Case const& c);

/// The gauges that have a place, as a list of the type Probe.
Json probes_of(Case const& c);

}  // namespace moraine::report
