#include "probes/grid_probe.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel_for.hpp"

namespace moraine {

Vec3 PlaceGrid::place(std::size_t index) const {
  std::array const along{index % points[0], index / points[0] % points[1],
                         index / (points[0] * points[1])};
  Vec3 x = origin;
  for (std::size_t axis = 0; axis < 3; ++axis)
    x[axis] += static_cast<double>(along[axis]) * step[axis];
  return x;
}

PlaceGrid grid_between(Vec3 const& min, Vec3 const& max, double step) {
  PlaceGrid grid;
  grid.origin = min;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double const length = max[axis] - min[axis];
    if (!(length > 0.0)) continue;
    // A length that is a whole number of steps must not get one more for its rounding error.
    double const cells = std::max(1.0, std::ceil(length / step - 1e-9));
    grid.points[axis] = static_cast<std::size_t>(cells) + 1;
    grid.step[axis] = length / cells;
  }
  return grid;
}

std::vector<PointState> probe_grid(ParticleStore const& store, Search const& search,
                                   KernelName kernel, double h, PlaceGrid const& grid) {
  std::vector<PointState> states(grid.size());
  for_each_block(states.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      states[i] = probe_point(store, search, kernel, h, grid.place(i));
  });
  return states;
}

}  // namespace moraine
