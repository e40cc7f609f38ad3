// How much of the kernel is filled with particles, at the nodes of a regular grid.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/vec3.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {

/// Particles as a surface is drawn of them.
struct Blobs {
  int dimension = 3;
  std::vector<Vec3> place;     // m
  std::vector<double> volume;  // m^d, mass by density
  std::vector<double> h;       // m
};

/// A function at the nodes of a grid, x fastest.
struct NodeGrid {
  std::array<std::size_t, 3> nodes{1, 1, 1};
  Vec3 origin{};      // m
  double cell = 1.0;  // m, along all axes
  std::vector<double> value;

  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    return (k * nodes[1] + j) * nodes[0] + i;
  }
  std::array<std::size_t, 3> of(std::size_t index) const {
    return {index % nodes[0], index / nodes[0] % nodes[1], index / (nodes[0] * nodes[1])};
  }
  Vec3 place(std::size_t index) const;
  /// Gradient by differences of neighbouring nodes [1/m]; one-sided at the ends.
  Vec3 gradient(std::size_t index) const;
};

/// s(x) = sum_j V_j W(x - x_j, h_j) at the nodes of a grid that is zero at all of its ends. Throws
/// std::runtime_error where there would be more than 2e8 nodes. cell in m.
NodeGrid filled_grid(Blobs const& blobs, KernelName kernel, double cell);

}  // namespace moraine
