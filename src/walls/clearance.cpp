#include "walls/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moraine {
namespace {

// How far a place is behind the plane of a side of the box, seen from inside; negative in front.
double beyond(BoxWall const& wall, std::size_t axis, std::size_t end, Vec3 const& place) {
  return end == 0 ? wall.min[axis] - place[axis] : place[axis] - wall.max[axis];
}

}  // namespace

double clearance(BoxWall const& wall, double thickness, Dummy const& dummy) {
  double least = std::numeric_limits<double>::infinity();
  double outside2 = 0.0;  // square of the distance to the box
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(wall.dimension); ++axis) {
    if (spans_period(wall, axis)) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      double const away = beyond(wall, axis, end, dummy.position);
      if (away > 0.0) outside2 += away * away;
      // An obstacle ends at all of its sides; a tank behind its layers, or at the rim of an open
      // side.
      bool const layers = wall.solid == SolidSide::outside && !wall.open[axis][end];
      least = std::min(least, (layers ? thickness : 0.0) - away);
    }
  }
  if (wall.solid == SolidSide::outside) least = std::min(least, std::sqrt(outside2));
  return std::max(least, 0.0);
}

}  // namespace moraine
