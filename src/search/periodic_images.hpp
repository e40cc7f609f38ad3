// Periodic sides by ghosts: images of particles near one side, placed beyond the opposite side.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/cell_grid.hpp"
#include "search/fixed_point.hpp"

namespace moraine {

/// A ghost: a copy of an owned particle, moved by whole periods.
struct Image {
  std::uint32_t source;
  std::array<std::int8_t, 3> shift;  // periods along each axis
};

/// Which axes repeat, and after how many metres and units. The period in units is rounded once, so
/// that x_ij of a pair and of its image are exactly opposite.
struct Periodicity {
  std::array<bool, 3> periodic{};
  std::array<double, 3> low{};     // m, lower side
  std::array<double, 3> period{};  // m
  std::array<std::int64_t, 3> period_units{};
  UnitPoint low_units{};

  bool any() const { return periodic[0] || periodic[1] || periodic[2]; }
  Units image_units(Units x, int shift, std::size_t axis) const {
    return static_cast<Units>(x + shift * period_units[axis]);
  }
};

/// Images of all points that lie within `reach` units of a periodic side. Appends their positions
/// and keys (so that they sort behind the owned points of a cell) to the arrays.
void append_images(Periodicity const& sides, int dimension, std::int64_t reach,
                   std::array<std::vector<Units>, 3>& points, std::vector<std::uint64_t>& key,
                   std::vector<Image>& images);

}  // namespace moraine
