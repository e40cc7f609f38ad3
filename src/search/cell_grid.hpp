// A regular grid of cells over fixed-point positions: who lies where, in geometric order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace moraine {

using Units = std::int32_t;  // fixed-point coordinate
using UnitPoint = std::array<Units, 3>;

/// Shape of a grid: cells are numbered row by row, x fastest.
struct GridShape {
  std::array<double, 3> origin{};  // units
  double edge = 1.0;               // units
  double inverse_edge = 1.0;       // 1 / units
  std::array<int, 3> cells{1, 1, 1};

  /// Covers [low, high] with cells of at least this edge; the edge doubles while there would be
  /// more than `most_cells`.
  static GridShape over(UnitPoint const& low, UnitPoint const& high, int dimension, double edge,
                        std::size_t most_cells);

  /// Cell along one axis, clamped to the grid. Monotonic in x, so that ranges of cells are safe.
  int along(double x, int axis) const {
    auto const k = static_cast<std::size_t>(axis);
    int const cell = static_cast<int>((x - origin[k]) * inverse_edge);
    return cell < 0 ? 0 : (cell >= cells[k] ? cells[k] - 1 : cell);
  }
  std::size_t index(int cx, int cy, int cz) const {
    return (static_cast<std::size_t>(cz) * static_cast<std::size_t>(cells[1]) +
            static_cast<std::size_t>(cy)) *
               static_cast<std::size_t>(cells[0]) +
           static_cast<std::size_t>(cx);
  }
  std::size_t size() const {
    return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) *
           static_cast<std::size_t>(cells[2]);
  }
};

using UnitSpans = std::array<std::span<Units const>, 3>;  // [axis][point]

/// Where the points of each cell stand in a row of points sorted by cell.
struct CellGrid {
  GridShape shape;
  int dimension = 3;
  std::vector<std::uint32_t> start;  // [cell]: first entry; one past the last cell at the end

  std::size_t size() const { return start.empty() ? 0 : start.back(); }
  std::size_t bytes() const { return start.capacity() * sizeof(std::uint32_t); }
};

/// Points in the order of a grid's entries, as the list builder reads them; a view.
struct CellPoints {
  CellGrid const& grid;
  UnitSpans x;                             // padded by `padding` readable values beyond the end
  std::span<std::uint32_t const> index{};  // of each entry, padded; empty: entry k is point k
  std::span<float const> support{};        // of each entry, padded [units]; empty: not told

  static constexpr std::size_t padding = 16;

  /// Calls visit(index of the point) for all points in the cells that a box [units] touches, and
  /// for none where it lies outside of the grid.
  template <class Visit>
  void for_each_in_box(std::array<double, 3> const& low, std::array<double, 3> const& high,
                       Visit&& visit) const {
    GridShape const& shape = grid.shape;
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < grid.dimension; ++axis) {
      auto const k = static_cast<std::size_t>(axis);
      double const end = shape.origin[k] + shape.edge * shape.cells[k];
      if (high[k] < shape.origin[k] || low[k] > end) return;
      first[k] = shape.along(std::max(low[k], shape.origin[k]), axis);
      last[k] = shape.along(std::min(high[k], end), axis);
    }
    for (int cz = first[2]; cz <= last[2]; ++cz)
      for (int cy = first[1]; cy <= last[1]; ++cy)
        for (std::uint32_t k = grid.start[shape.index(first[0], cy, cz)];
             k < grid.start[shape.index(last[0], cy, cz) + 1]; ++k)
          visit(index.empty() ? k : index[k]);
  }
};

/// Sorts points by cell; keeps its working memory between calls.
class CellSort {
 public:
  /// Sorts by cell of `shape` and, inside a cell, by key; sets the grid's shape and starts. Returns
  /// the index of the point of each entry, valid until the next call.
  std::span<std::uint32_t const> operator()(GridShape const& shape, int dimension,
                                            UnitSpans const& points,
                                            std::span<std::uint64_t const> key, CellGrid& grid);

  std::size_t bytes() const {
    return (cell_of_.capacity() + entry_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  std::vector<std::uint32_t> cell_of_;  // [point]
  std::vector<std::uint32_t> entry_;    // [entry]
};

}  // namespace moraine
