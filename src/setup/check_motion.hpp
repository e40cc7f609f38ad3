// Checks of prescribed motions, and the motions that they describe.
#pragma once

#include <optional>
#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Checks the motion of a wall whose keys begin with `key` ("wall.gate.motion."), and makes
/// spec.motion; reports mistakes to the source.
void check_motion(MotionSpec& spec, std::string const& key, Case const& c, Source& source);

/// The box around all places of a box that moves, from the start to the end of the run; between
/// 1000 instants the motion is not looked at.
Box swept_box(Box const& box, MotionSpec const& spec, Case const& c);

}  // namespace moraine
