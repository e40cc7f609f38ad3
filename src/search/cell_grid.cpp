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

std::span<std::uint32_t const> CellSort::operator()(GridShape const& shape, int dimension,
                                                    UnitSpans const& points,
                                                    std::span<std::uint64_t const> key,
                                                    CellGrid& grid) {
  grid.shape = shape;
  grid.dimension = dimension;
  auto& start = grid.start;
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
  entry_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    entry_[start[cell_of_[i]]++] = static_cast<std::uint32_t>(i);
  for (std::size_t c = shape.size(); c > 0; --c) start[c] = start[c - 1];
  start[0] = 0;

  for_each_block(shape.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
      std::sort(entry_.begin() + start[c], entry_.begin() + start[c + 1],
                [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  });
  return entry_;
}

}  // namespace moraine
