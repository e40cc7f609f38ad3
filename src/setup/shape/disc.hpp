// Discs and balls.
#pragma once

#include "setup/shape/box.hpp"

namespace moraine {

/// Disc in 2D, ball in 3D, interval in 1D.
struct Disc {
  Point center{};
  double radius = 0.0;  // m
};

/// Inside or on the boundary, to which points closer than `tolerance` [m] count.
inline bool contains(Disc const& disc, Point const& point, int, double tolerance) {
  Point const from = subtract(point, disc.center);
  return std::hypot(from[0], from[1], from[2]) <= disc.radius + tolerance;
}

/// The smallest box around the disc.
inline Box bounds(Disc const& disc, int dimension) {
  Box box{disc.center, disc.center};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    box.min[axis] -= disc.radius;
    box.max[axis] += disc.radius;
  }
  return box;
}

}  // namespace moraine
