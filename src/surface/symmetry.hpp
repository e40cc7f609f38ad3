// Symmetry planes at sides of the domain, and sums for the whole body that they stand for.
#pragma once

#include <array>
#include <cstddef>

#include "base/vec3.hpp"

namespace moraine {

/// Sides of the domain that reflect it. The whole is the domain with its mirror images: an axis
/// with one plane doubles it. Between two planes the body repeats itself without end; sums are
/// those of the domain along such an axis.
struct Symmetry {
  std::array<std::array<bool, 2>, 3> planes{};  // [axis][0: minus side, 1: plus side]

  bool any() const {
    for (auto const& axis : planes)
      if (axis[0] || axis[1]) return true;
    return false;
  }
  bool doubles(std::size_t axis) const { return planes[axis][0] != planes[axis][1]; }

  /// How many times the domain fits into the whole: 1, 2, 4 or 8.
  int copies() const {
    int count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) count *= doubles(axis) ? 2 : 1;
    return count;
  }

  /// A sum over the whole, of a quantity without direction and of a vector such as momentum or
  /// force, whose parts across a plane cancel.
  double whole(double sum) const { return copies() * sum; }
  Vec3 whole(Vec3 const& sum) const {
    Vec3 result{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!doubles(axis)) result[axis] = copies() * sum[axis];
    return result;
  }

  /// Calls use(place, force) for a force and for all of its mirror images. low, high: corners of
  /// the domain.
  template <class Use>
  void for_each_image(Vec3 const& low, Vec3 const& high, Vec3 place, Vec3 force, Use&& use,
                      std::size_t axis = 0) const {
    if (axis == 3) return use(place, force);
    for_each_image(low, high, place, force, use, axis + 1);
    if (!doubles(axis)) return;
    place[axis] = 2.0 * (planes[axis][0] ? low[axis] : high[axis]) - place[axis];
    force[axis] = -force[axis];
    for_each_image(low, high, place, force, use, axis + 1);
  }
};

}  // namespace moraine
