// Sides of the domain that continue it: images of particles near one side stand beyond a side.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/cell_grid.hpp"
#include "search/cell_motion.hpp"
#include "search/fixed_point.hpp"

namespace moraine {

/// What reflects at a side of the domain; nothing at an open one. A symmetry plane and a free-slip
/// wall reverse the velocity across the plane, a no-slip wall reverses all of it. What a wall does
/// to the fluid is told as a force; beyond a symmetry plane there is the other half of the whole.
enum class Plane : std::uint8_t { open, symmetry, slip_wall, stick_wall };

/// A copy of an owned particle: along each axis moved by whole periods, or reflected at the lower
/// (-1) or upper (+1) side.
struct Image {
  std::uint32_t source;
  std::array<std::int8_t, 3> shift;  // along each axis
};

/// Which sides repeat or reflect the domain. A length in units is rounded once, so that x_ij of a
/// pair and of its image are exactly opposite.
///
/// Periodic axes: everything stands again one length further. Planes: everything stands again on
/// the other side of the plane. An axis is not both.
struct DomainSides {
  std::array<bool, 3> periodic{};
  std::array<std::array<Plane, 2>, 3> planes{};  // [axis][0: lower side, 1: upper side]
  std::array<double, 3> low{};                   // m, lower side
  std::array<double, 3> length{};                // m, from the lower to the upper side
  std::array<std::int64_t, 3> length_units{};
  UnitPoint low_units{};

  bool repeats() const { return periodic[0] || periodic[1] || periodic[2]; }
  /// Whether there are images at all.
  bool any() const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (periodic[axis] || reflects(axis)) return true;
    return false;
  }
  bool reflects(std::size_t axis, std::size_t end) const {
    return planes[axis][end] != Plane::open;
  }
  bool reflects(std::size_t axis) const { return reflects(axis, 0) || reflects(axis, 1); }
  bool is_symmetric(std::size_t axis, std::size_t end) const {
    return planes[axis][end] == Plane::symmetry;
  }
  bool is_wall(std::size_t axis, std::size_t end) const {
    return planes[axis][end] == Plane::slip_wall || planes[axis][end] == Plane::stick_wall;
  }
  bool any_wall() const {
    for (std::size_t side = 0; side < 6; ++side)
      if (is_wall(side / 2, side % 2)) return true;
    return false;
  }
  /// Where the planes are, in units.
  MirrorPlaces plane_units() const {
    MirrorPlaces places = no_planes();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (reflects(axis, 0)) places[axis][0] = low_units[axis];
      if (reflects(axis, 1))
        places[axis][1] = static_cast<double>(low_units[axis] + length_units[axis]);
    }
    return places;
  }
  /// Whether a point is within `reach` of a wall, or beyond it; both in units.
  bool near_wall(UnitPoint const& x, double reach) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double const ahead = static_cast<double>(x[axis]) - low_units[axis];
      if (is_wall(axis, 0) && ahead <= reach) return true;
      if (is_wall(axis, 1) && static_cast<double>(length_units[axis]) - ahead <= reach) return true;
    }
    return false;
  }

  /// The plane that an image with this shift along an axis was reflected at, if any.
  Plane plane_of(int shift, std::size_t axis) const {
    return shift == 0 ? Plane::open : planes[axis][shift > 0 ? 1 : 0];
  }
  /// Whether an image was reflected at a wall, alone or together with other sides.
  bool at_wall(Image const& image) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (plane_of(image.shift[axis], axis) > Plane::symmetry) return true;
    return false;
  }

  /// Whether an image with this shift is reflected along the axis.
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
