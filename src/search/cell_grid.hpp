// A regular grid of cells over fixed-point positions: who lies where, in geometric order.
#pragma once

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

/// Points sorted by cell, as plain coordinate arrays that the list builder reads in rows.
struct CellGrid {
  GridShape shape;
  int dimension = 3;
  std::vector<std::uint32_t> start;     // [cell]: first entry; one past the last cell at the end
  std::array<std::vector<Units>, 3> x;  // [axis][entry]
  std::vector<std::uint32_t> entry;     // [entry]: index of the point as given to `fill`

  /// Sorts points by cell and, inside a cell, by key; returns nothing lost: entry.size() points.
  /// Arrays are padded by `padding` readable entries beyond the end.
  void fill(GridShape const& new_shape, int new_dimension,
            std::array<std::span<Units const>, 3> const& points,
            std::span<std::uint64_t const> key);

  std::size_t size() const { return start.empty() ? 0 : start.back(); }
  std::size_t bytes() const;

  static constexpr std::size_t padding = 16;

 private:
  std::vector<std::uint32_t> cell_of_;
};

}  // namespace moraine
