// Sides of the domain that continue it: images of particles near one side stand beyond a side.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/cell_grid.hpp"
#include "search/fixed_point.hpp"

namespace moraine {

/// A copy of an owned particle: along each axis moved by whole periods, or reflected at the lower
/// (-1) or upper (+1) side.
struct Image {
  std::uint32_t source;
  std::array<std::int8_t, 3> shift;  // along each axis
};

/// Which sides repeat or reflect the domain. A length in units is rounded once, so that x_ij of a
/// pair and of its image are exactly opposite.
///
/// Periodic axes: everything stands again one length further. Symmetry planes: everything stands
/// again on the other side of the plane, with the velocity across it reversed; this is also a rigid
/// free-slip wall. An axis is not both.
struct DomainSides {
  std::array<bool, 3> periodic{};
  std::array<std::array<bool, 2>, 3> symmetric{};  // [axis][0: lower side, 1: upper side]
  std::array<double, 3> low{};                     // m, lower side
  std::array<double, 3> length{};                  // m, from the lower to the upper side
  std::array<std::int64_t, 3> length_units{};
  UnitPoint low_units{};

  /// Whether there are images at all.
  bool any() const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (periodic[axis] || reflects(axis)) return true;
    return false;
  }
  bool reflects(std::size_t axis) const { return symmetric[axis][0] || symmetric[axis][1]; }

  /// Whether an image with this shift has its velocity along the axis reversed.
  bool reverses(int shift, std::size_t axis) const { return shift != 0 && !periodic[axis]; }

  /// A coordinate of the image with this shift: units, m.
  Units image_units(Units x, int shift, std::size_t axis) const {
    if (reverses(shift, axis))
      return static_cast<Units>(2 * plane(low_units[axis], length_units[axis], shift) - x);
    return static_cast<Units>(x + shift * length_units[axis]);
  }
  double image_place(double x, int shift, std::size_t axis) const {
    if (reverses(shift, axis)) return 2.0 * plane(low[axis], length[axis], shift) - x;
    return x + shift * length[axis];
  }

 private:
  template <class Low, class Length>
  static Length plane(Low low, Length length, int shift) {
    return shift < 0 ? static_cast<Length>(low) : static_cast<Length>(low) + length;
  }
};

/// Images of all points that lie within `reach` units of a side that makes images. Appends their
/// positions and keys (so that they sort behind the owned points of a cell) to the arrays.
void append_images(DomainSides const& sides, int dimension, std::int64_t reach,
                   std::array<std::vector<Units>, 3>& points, std::vector<std::uint64_t>& key,
                   std::vector<Image>& images);

}  // namespace moraine
