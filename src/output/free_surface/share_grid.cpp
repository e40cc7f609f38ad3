#include "output/free_surface/share_grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "probes/kernel_shape.hpp"

namespace moraine {
namespace {

constexpr double most_nodes = 2e8;

/// The grid around all supports, without values.
NodeGrid grid_around(Blobs const& blobs, double cell) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  NodeGrid grid;
  grid.cell = cell;
  if (blobs.place.empty()) return grid;
  double count = 1.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(blobs.dimension); ++axis) {
    double low = infinity, high = -infinity;
    for (std::size_t j = 0; j < blobs.place.size(); ++j) {
      double const reach = kernel_support * blobs.h[j];
      low = std::min(low, blobs.place[j][axis] - reach);
      high = std::max(high, blobs.place[j][axis] + reach);
    }
    grid.origin[axis] = low - cell;
    double const nodes = std::ceil((high - low) / cell) + 3.0;
    count *= nodes;
    if (!(count <= most_nodes))
      throw std::runtime_error(
          fmt::format("the surface needs a grid of more than {:.0e} nodes {:.4g} m apart: the "
                      "particles are spread too far",
                      most_nodes, cell));
    grid.nodes[axis] = static_cast<std::size_t>(nodes);
  }
  return grid;
}

struct Window {
  std::array<std::size_t, 3> first{}, last{};
};

Window window_of(NodeGrid const& grid, Vec3 const& x, double reach, int dimension) {
  Window window;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    double const at = (x[axis] - grid.origin[axis]) / grid.cell;
    window.first[axis] = static_cast<std::size_t>(std::ceil(at - reach / grid.cell));
    window.last[axis] = static_cast<std::size_t>(std::floor(at + reach / grid.cell));
  }
  return window;
}

/// Adds a particle to all nodes that it reaches.
template <class Kernel>
void include(NodeGrid& grid, Blobs const& blobs, std::size_t j, Kernel const& kernel) {
  double const h = blobs.h[j];
  double const reach = kernel_support * h;
  double const weight = blobs.volume[j] * kernel.sigma / std::pow(h, blobs.dimension);
  Window const window = window_of(grid, blobs.place[j], reach, blobs.dimension);
  for (std::size_t k = window.first[2]; k <= window.last[2]; ++k)
    for (std::size_t m = window.first[1]; m <= window.last[1]; ++m)
      for (std::size_t i = window.first[0]; i <= window.last[0]; ++i) {
        std::size_t const node = grid.index(i, m, k);
        double const r = norm(subtract(grid.place(node), blobs.place[j]));
        if (r < reach) grid.value[node] += weight * kernel.shape(r / h);
      }
}

}  // namespace

Vec3 NodeGrid::place(std::size_t index) const {
  auto const along = of(index);
  Vec3 x = origin;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (nodes[axis] > 1) x[axis] += cell * static_cast<double>(along[axis]);
  return x;
}

Vec3 NodeGrid::gradient(std::size_t index) const {
  auto const along = of(index);
  std::array const stride{std::size_t{1}, nodes[0], nodes[0] * nodes[1]};
  Vec3 slope{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (nodes[axis] == 1) continue;
    std::size_t const before = along[axis] > 0 ? 1 : 0;
    std::size_t const after = along[axis] + 1 < nodes[axis] ? 1 : 0;
    slope[axis] = (value[index + after * stride[axis]] - value[index - before * stride[axis]]) /
                  (cell * static_cast<double>(before + after));
  }
  return slope;
}

NodeGrid filled_grid(Blobs const& blobs, KernelName kernel, double cell) {
  NodeGrid grid = grid_around(blobs, cell);
  grid.value.assign(grid.nodes[0] * grid.nodes[1] * grid.nodes[2], 0.0);
  with_kernel(kernel, blobs.dimension, [&](auto const& any) {
    for (std::size_t j = 0; j < blobs.place.size(); ++j) include(grid, blobs, j, any);
    return 0.0;
  });
  return grid;
}

}  // namespace moraine
