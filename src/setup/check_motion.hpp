// Checks of prescribed motions, and the motions that they describe.
#pragma once

#include <optional>
#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Checks the motion of a wall, whose keys begin with `key` ("wall.gate.motion."), and makes
/// wall.motion.motion; reports mistakes to the source.
void check_motion(WallSpec& wall, std::string const& key, Case const& c, Source& source);

/// Until when a wall is there at the latest [s]: until the stage that removes it begins, where all
/// stages before that one end by time, else to the end of the run.
double end_of_wall(Case const& c, WallSpec const& wall);

/// The box around all places of a wall as long as it is there; between 1000 instants the motion is
/// not looked at. Along a periodic axis that of the wall at rest, unless it turns.
Box swept_box(WallSpec const& wall, Case const& c);

}  // namespace moraine
