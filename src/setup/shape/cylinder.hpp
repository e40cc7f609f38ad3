// Cylinders about any axis.
#pragma once

#include <algorithm>

#include "setup/shape/box.hpp"

namespace moraine {

/// Round cylinder between the middles of its two ends; in 2D the strip of width 2 radius between
/// two points.
struct Cylinder {
  Point start{};
  Point end{};
  double radius = 0.0;  // m
};

/// Inside. The mantle and the end at `start` belong to the cylinder, the end at `end` does not, so
/// that a point belongs to exactly one of two cylinders placed end to end. Points closer to a face
/// than `tolerance` [m] count as on it.
inline bool contains(Cylinder const& cylinder, Point const& point, int, double tolerance) {
  Point const along = subtract(cylinder.end, cylinder.start);
  double const length = norm(along);
  Point const unit = scale(1.0 / length, along);
  Point const from = subtract(point, cylinder.start);
  double const height = dot(from, unit);
  if (height < -tolerance || height >= length - tolerance) return false;
  return norm(subtract(from, scale(height, unit))) <= cylinder.radius + tolerance;
}

/// The smallest box around the cylinder: along an axis the discs at its ends reach
/// radius sqrt(1 - u^2) beyond their middles, u the component of the cylinder's direction.
inline Box bounds(Cylinder const& cylinder, int dimension) {
  Point const along = subtract(cylinder.end, cylinder.start);
  double const length = norm(along);
  Box box;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    double const u = along[axis] / length;
    double const reach = cylinder.radius * std::sqrt(std::max(0.0, 1.0 - u * u));
    box.min[axis] = std::min(cylinder.start[axis], cylinder.end[axis]) - reach;
    box.max[axis] = std::max(cylinder.start[axis], cylinder.end[axis]) + reach;
  }
  return box;
}

}  // namespace moraine
