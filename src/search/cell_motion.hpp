// How far the points of one kind have moved since the lists were made, as boxes per coarse cell.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "search/cell_grid.hpp"

namespace moraine {

/// A box of displacements per coarse cell [axis][cell], in units; low > high where no point is.
struct MotionBoxes {
  static constexpr float nothing = std::numeric_limits<float>::infinity();
  std::array<std::vector<float>, 3> low, high;

  std::size_t bytes() const;
};

/// The smallest and the largest displacement along an axis [units].
struct MotionRange {
  float low = MotionBoxes::nothing;
  float high = -MotionBoxes::nothing;

  void include(MotionRange const& other) {
    low = other.low < low ? other.low : low;
    high = other.high > high ? other.high : high;
  }
};

/// Places of planes that reflect [axis][end], in units; infinite where there is none.
using MirrorPlaces = std::array<std::array<double, 2>, 3>;
constexpr MirrorPlaces no_planes() {
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  return {{{-nowhere, nowhere}, {-nowhere, nowhere}, {-nowhere, nowhere}}};
}

/// Where the points of a kind were when the lists were made, and in which coarse cell.
class CellMotion {
 public:
  /// Takes the reference positions [axis][point] in units; no points: nothing moves.
  void reset(GridShape const& coarse, int dimension, UnitSpans const& positions);

  /// Finds the boxes of all cells: of their own points, and of those of the cells around too, or of
  /// all cells where not `local`. Displacements across a plane count both ways in cells within
  /// `reach` units of it: the image of a neighbour is the neighbour of a point that the neighbour
  /// itself is near to.
  void collect(UnitSpans const& positions, bool local, MirrorPlaces const& planes, double reach);

  bool empty() const { return order_.empty(); }
  bool empty(std::size_t cell) const { return start_[cell] == start_[cell + 1]; }
  MotionRange own(std::size_t axis, std::size_t cell) const {
    return {own_.low[axis][cell], own_.high[axis][cell]};
  }
  MotionRange around(std::size_t axis, std::size_t cell) const {
    return {around_.low[axis][cell], around_.high[axis][cell]};
  }
  /// Of all points.
  MotionRange all(std::size_t axis) const;

  /// Reference positions along one axis, in the order of the points.
  std::span<Units const> reference(std::size_t axis) const { return reference_[axis]; }

  std::size_t bytes() const;

 private:
  void collect_own(UnitSpans const& positions);
  void spread(int axis);
  void spread_everywhere(MirrorPlaces const& planes);
  void reflect(MirrorPlaces const& planes, double reach);

  int dimension_ = 3;
  GridShape coarse_;
  std::vector<std::uint32_t> order_;  // points by coarse cell
  std::vector<std::uint32_t> start_;  // [coarse cell]
  std::array<std::vector<Units>, 3> reference_;
  MotionBoxes own_, around_, scratch_;
};

/// Coarse cell of a point.
inline std::size_t cell_of(GridShape const& grid, int dimension, UnitPoint const& x) {
  int c[3] = {0, 0, 0};
  for (int axis = 0; axis < dimension; ++axis)
    c[axis] = grid.along(x[static_cast<std::size_t>(axis)], axis);
  return grid.index(c[0], c[1], c[2]);
}

/// Point i of columns of coordinates [axis][point].
template <class Columns>
UnitPoint point_of(Columns const& x, int dimension, std::size_t i) {
  UnitPoint p{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    p[axis] = x[axis][i];
  return p;
}

}  // namespace moraine
