// Layers of materials in a region.
#pragma once

#include <cstddef>
#include <optional>

#include "setup/case.hpp"

namespace moraine {

/// The axis that "up" lies on, and its sense along it.
struct Upward {
  std::size_t axis = 0;
  double sign = 1.0;
  double height(Point const& point) const { return sign * point[axis]; }
};

/// Against gravity; without gravity the last axis of the case. Nothing where gravity is oblique.
std::optional<Upward> upward_of(Case const& c);

/// Height of the top of a region's uppermost layer [m].
double top_of_layers(RegionSpec const& region, Case const& c, Upward const& upward);

/// Which layer a height [m] lies in, 0 the uppermost; nothing above the top and below the last
/// thickness. Half-open as a box seen along the axis: of two layers that touch, a point on their
/// common face belongs to the one towards larger coordinates. Points closer to a face than
/// `tolerance` [m] count as on it.
std::optional<std::size_t> layer_at(Layers const& layers, double top, double height, double sign,
                                    double tolerance);

}  // namespace moraine
