// Polygons in 2D, prisms over them in 3D.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setup/shape/box.hpp"

namespace moraine {

/// Closed line through the corners, in either sense of rotation; the last corner is joined to the
/// first. In 3D it lies across `axis`, its corners are (x, y), (y, z) or (x, z), and it is extruded
/// along the axis between two coordinates.
struct Polygon {
  std::vector<double> corners;  // m, x and y of each in turn
  int axis = 2;                 // 3D
  std::optional<double> from;   // m, 3D
  std::optional<double> to;     // m, 3D

  std::size_t size() const { return corners.size() / 2; }
  std::array<double, 2> corner(std::size_t i) const {
    std::size_t const k = i % size();
    return {corners[2 * k], corners[2 * k + 1]};
  }
};

/// Inside, by counting the sides that a ray crosses; exact for any polygon that does not cross
/// itself. Half-open as a box: points on a side belong to it where the inside lies towards larger
/// coordinates, so that touching polygons share no point. Points closer to a side than `tolerance`
/// [m] count as on it.
bool contains(Polygon const& polygon, Point const& point, int dimension, double tolerance);

/// The smallest box around the polygon or prism.
Box bounds(Polygon const& polygon, int dimension);

/// Area between the corners [m^2], never negative: Gauss's formula.
double area(Polygon const& polygon);

/// What makes the corners no polygon, as a message that follows them: fewer than three, one twice
/// in a row, sides that touch or cross. Empty for a sound polygon.
std::string defect_of(Polygon const& polygon);

}  // namespace moraine
