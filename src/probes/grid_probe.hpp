// The fluid's state at the points of a regular grid.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/vec3.hpp"
#include "probes/point_probe.hpp"

namespace moraine {

/// Points at equal distances along the axes, x fastest.
struct PlaceGrid {
  std::array<std::size_t, 3> points{1, 1, 1};
  Vec3 origin{};             // m
  Vec3 step{1.0, 1.0, 1.0};  // m; along an axis with one point of no meaning

  std::size_t size() const { return points[0] * points[1] * points[2]; }
  Vec3 place(std::size_t index) const;
};

/// The grid whose first and last points are these, at distances of at most `step` [m].
PlaceGrid grid_between(Vec3 const& min, Vec3 const& max, double step);

/// probe_point at all points of a grid.
std::vector<PointState> probe_grid(ParticleStore const& store, Search const& search,
                                   KernelName kernel, double h, PlaceGrid const& grid);

}  // namespace moraine
