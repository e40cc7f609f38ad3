// Axis-aligned boxes.
#pragma once

#include <cstddef>

#include "setup/shape/point.hpp"

namespace moraine {

/// Axis-aligned box between two corners (an interval in 1D, a rectangle in 2D).
struct Box {
  Point min{};
  Point max{};
};

/// Inside, half-open: a point on a lower face belongs to the box, one on an upper face does not, so
/// that a point belongs to exactly one of two boxes that touch. Points closer to a face than
/// `tolerance` [m] count as on it.
inline bool contains(Box const& box, Point const& point, int dimension, double tolerance) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    if (point[axis] < box.min[axis] - tolerance || point[axis] >= box.max[axis] - tolerance)
      return false;
  return true;
}

}  // namespace moraine
