// Positions as 32-bit fixed point over the domain.
//
// Differences of two positions are then exact and exactly antisymmetric, the same bits on any rank,
// and free of the loss of digits that single precision has far from the origin.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace moraine {

/// Maps metres to integer units: unit = (x - center) / scale. The domain takes the middle half of
/// the range, so that the difference of any two positions inside fits into 32 bits.
struct FixedPoint {
  double scale = 1.0;  // m per unit
  std::array<double, 3> center{};

  std::int32_t units(double x, int axis) const {
    return static_cast<std::int32_t>(
        std::lrint((x - center[static_cast<std::size_t>(axis)]) / scale));
  }

  /// A mapping for a box of these corners [m].
  static FixedPoint over(std::array<double, 3> const& min, std::array<double, 3> const& max,
                         int dimension) {
    FixedPoint map;
    double extent = 0.0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      map.center[axis] = 0.5 * (min[axis] + max[axis]);
      extent = std::fmax(extent, max[axis] - min[axis]);
    }
    map.scale = extent / 2147483648.0;
    return map;
  }

  /// A position far from all others, for the padding of neighbour lists.
  static constexpr std::int32_t nowhere = INT32_MIN + 1;
};

}  // namespace moraine
