#include "probes/crater_probe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/parallel_for.hpp"
#include "probes/crater_profile.hpp"

namespace moraine {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Unit vectors of the plan: the two sides in 2D, the middles of the sectors in 3D.
std::vector<Vec3> directions(int dimension, std::size_t up, int sectors) {
  if (dimension == 2) {
    Vec3 side{};
    side[1 - up] = 1.0;
    return {scale(-1.0, side), side};
  }
  std::vector<Vec3> rays;
  for (int k = 0; k < sectors; ++k) {
    double const angle = 2.0 * std::numbers::pi * (k + 0.5) / sectors;
    Vec3 ray{};
    ray[(up + 1) % 3] = std::cos(angle);
    ray[(up + 2) % 3] = std::sin(angle);
    rays.push_back(ray);
  }
  return rays;
}

/// How far a ray stays in the domain.
double reach_of(CraterPlace const& at, Vec3 const& ray, std::size_t up) {
  double reach = at.radius;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis == up || ray[axis] == 0.0) continue;
    double const side = ray[axis] > 0.0 ? at.high[axis] : at.low[axis];
    reach = std::min(reach, (side - at.center[axis]) / ray[axis]);
  }
  return reach;
}

/// The ground along a ray, as far as there is any.
CraterProfile profile_along(BodyView const& ground, CraterPlace const& at, Vec3 const& ray,
                            double reach, HeightRange const& heights) {
  CraterProfile profile{0.5 * at.spacing, {}};
  profile.height.resize(static_cast<std::size_t>(reach / profile.step) + 1);
  double const top = heights.high + 2.0 * ground.h;
  for_each_block(profile.height.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      Vec3 const place = add(at.center, scale(profile.step * static_cast<double>(k), ray));
      profile.height[k] = surface_height(ground, place, top, heights.low) - at.level;
    }
  });
  while (!profile.height.empty() && std::isnan(profile.height.back())) profile.height.pop_back();
  for (double& height : profile.height)
    if (std::isnan(height)) height = heights.low - at.level;
  return profile;
}

double mean(std::vector<ProfileReading> const& readings, double ProfileReading::*member) {
  double sum = 0.0;
  for (ProfileReading const& reading : readings) sum += reading.*member;
  return sum / static_cast<double>(readings.size());
}

}  // namespace

CraterReading probe_crater(BodyView const& ground, CraterPlace const& at) {
  HeightRange const heights = heights_of(ground);
  int const dimension = ground.store.dimension();
  std::vector<ProfileReading> readings;
  if (heights.low <= heights.high)
    for (Vec3 const& ray : directions(dimension, ground.up.axis, at.sectors)) {
      double const reach = reach_of(at, ray, ground.up.axis);
      if (!(reach >= 2.0 * at.spacing)) continue;
      auto const profile = profile_along(ground, at, ray, reach, heights);
      if (!profile.height.empty())
        readings.push_back(read_profile(profile, 0.25 * at.spacing, dimension == 3));
    }
  if (readings.empty()) return {nothing, nothing, nothing, nothing, nothing};
  CraterReading crater;
  crater.apparent_diameter = 2.0 * mean(readings, &ProfileReading::apparent_radius);
  crater.rim_diameter = 2.0 * mean(readings, &ProfileReading::rim_radius);
  crater.rim_height = mean(readings, &ProfileReading::rim_height);
  double const whole = dimension == 3 ? 2.0 * std::numbers::pi : 2.0;
  crater.volume = whole * mean(readings, &ProfileReading::content);
  for (ProfileReading const& reading : readings)
    crater.depth = std::max(crater.depth, reading.depth);
  return crater;
}

}  // namespace moraine
