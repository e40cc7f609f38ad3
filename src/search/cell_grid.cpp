#include "search/cell_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel_for.hpp"

namespace moraine {

GridShape GridShape::over(UnitPoint const& low, UnitPoint const& high, int dimension, double edge,
                          std::size_t most_cells) {
  GridShape shape;
  for (;; edge *= 2.0) {
    shape.edge = edge;
    shape.inverse_edge = 1.0 / edge;
    double count = 1.0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      shape.origin[axis] = low[axis];
      double const extent = static_cast<double>(high[axis]) - static_cast<double>(low[axis]);
      double const cells = std::floor(extent / edge) + 1.0;
      count *= cells;
      if (cells < 1e9) shape.cells[axis] = static_cast<int>(cells);
    }
    if (count <= static_cast<double>(most_cells)) return shape;
  }
}

void CellGrid::fill(GridShape const& new_shape, int new_dimension,
                    std::array<std::span<Units const>, 3> const& points,
                    std::span<std::uint64_t const> key) {
  shape = new_shape;
  dimension = new_dimension;
  std::size_t const count = key.size();
  cell_of_.resize(count);
  for_each_block(count, loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      int c[3] = {0, 0, 0};
      for (int axis = 0; axis < dimension; ++axis)
        c[axis] = shape.along(points[static_cast<std::size_t>(axis)][i], axis);
      cell_of_[i] = static_cast<std::uint32_t>(shape.index(c[0], c[1], c[2]));
    }
  });

  start.assign(shape.size() + 1, 0);
  for (std::uint32_t const cell : cell_of_) ++start[cell + 1];
  for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
  entry.resize(count + padding);
  for (std::size_t i = 0; i < count; ++i)
    entry[start[cell_of_[i]]++] = static_cast<std::uint32_t>(i);
  for (std::size_t c = shape.size(); c > 0; --c) start[c] = start[c - 1];
  start[0] = 0;

  for_each_block(shape.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
      std::sort(entry.begin() + start[c], entry.begin() + start[c + 1],
                [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  });

  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    x[axis].resize(count + padding);
    for_each_block(count, loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) x[axis][k] = points[axis][entry[k]];
    });
  }
}

std::size_t CellGrid::bytes() const {
  std::size_t words = start.capacity() + entry.capacity() + cell_of_.capacity();
  for (auto const& axis : x) words += axis.capacity();
  return words * 4;
}

}  // namespace moraine
