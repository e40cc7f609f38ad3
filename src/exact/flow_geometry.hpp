// Flows that depend on one coordinate.
#pragma once

#include <numbers>

namespace moraine {

/// What the coordinate r of a one-dimensional flow means; the value is the number of dimensions.
enum class FlowGeometry { planar = 1, cylindrical = 2, spherical = 3 };

/// Number of dimensions of the geometry, 1 to 3.
constexpr int dimensions(FlowGeometry geometry) { return static_cast<int>(geometry); }

/// Area at r = 1 m: 1 (one side of the plane r = 0), 2 pi, 4 pi.
constexpr double unit_area(FlowGeometry geometry) {
  if (geometry == FlowGeometry::planar) return 1.0;
  return (geometry == FlowGeometry::cylindrical ? 2.0 : 4.0) * std::numbers::pi;
}

}  // namespace moraine
