// What a profile of the ground from the axis of a crater outwards says about the crater.
#pragma once

#include <vector>

namespace moraine {

/// Heights of the ground above its original level [m] at the distances 0, step, 2 step ... from the
/// axis; negative inside the crater.
struct CraterProfile {
  double step = 0.0;  // m
  std::vector<double> height;
};

struct ProfileReading {
  double apparent_radius = 0.0;  // m, where the ground meets its original level
  double rim_radius = 0.0;       // m, of the highest place of the rim
  double rim_height = 0.0;       // m, above the original level
  double depth = 0.0;            // m, of the deepest place
  double content = 0.0;  // of a plane section: integral of depth dr [m^2]; in 3D: times r dr [m^3]
};

/// With `tolerance` the least depth that counts: the crater ends, seen from its deepest place
/// outwards, where the depth falls below the tolerance; if the ground then rises above its original
/// level within 8 tolerances further, where it meets the level, by linear interpolation. The rim is
/// the highest place between the end and twice its distance; no higher than the tolerance, it is
/// the end itself. The content is the part below the original level from the axis to the end
/// (trapezoidal rule). All zero where the deepest place is no deeper than the tolerance. Radii and
/// rim are not numbers where the ground does not come back to its level before the profile ends;
/// the content then is that of the whole profile.
ProfileReading read_profile(CraterProfile const& profile, double tolerance, bool round);

}  // namespace moraine
