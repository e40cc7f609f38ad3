// Half-planes and half-spaces.
#pragma once

#include "setup/shape/point.hpp"

namespace moraine {

/// All points x with (x - point) . normal <= 0: the normal points out of the filled side.
struct HalfPlane {
  Point point{};
  Point normal{};  // unit length after reading
};

/// Inside or on the plane, to which points closer than `tolerance` [m] count.
inline bool contains(HalfPlane const& plane, Point const& point, int, double tolerance) {
  return dot(subtract(point, plane.point), plane.normal) <= tolerance;
}

}  // namespace moraine
