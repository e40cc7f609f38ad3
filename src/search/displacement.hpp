// How far points have moved against their neighbours since the lists were made.
//
// A list with a skin stays complete while no two points that could be neighbours have moved against
// each other by more than the skin. The bound is local: the water of a fast, smooth stream keeps
// its list although it travels far. Boxes of displacement are kept per coarse cell (edge >= the
// list radius) and compared with those of the cells around.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/cell_grid.hpp"

namespace moraine {

class DisplacementBound {
 public:
  /// Takes the reference positions [axis][point], already sorted along `grid` (entry k is point k
  /// for owned points), and where walls are. radius in units. `local` false: neighbours may lie
  /// across a periodic side, so the bound is taken over all cells.
  void reset(CellPoints const& fluid, CellPoints const& walls, std::size_t owned, double radius,
             bool local, UnitSpans const& positions);

  /// Largest possible relative displacement [units] of two neighbouring points; infinite when
  /// points of cells that do not touch may have come near each other.
  struct Largest {
    double fluid = 0.0;  // two fluid points
    double wall = 0.0;   // a fluid point and a wall point
  };
  Largest largest(UnitSpans const& positions);

  /// Reference positions along one axis, in the order of the points.
  std::span<Units const> reference(std::size_t axis) const { return reference_[axis]; }

  /// False where no wall point, or no fluid point, can be a neighbour of a point here.
  bool near_wall(UnitPoint const& x) const { return near_wall_[coarse_cell(x)] != 0; }
  bool near_fluid(UnitPoint const& x) const { return near_fluid_[coarse_cell(x)] != 0; }

  /// No point has moved farther than this [units] since `reset` while `largest` is finite.
  double longest_motion() const { return far_limit_; }

  std::size_t bytes() const;

 private:
  struct Boxes {
    std::array<std::vector<float>, 3> low, high;  // [axis][coarse cell], units
  };
  std::size_t coarse_cell(UnitPoint const& x) const;
  void collect(UnitSpans const& positions);
  void mark(CellPoints const& points, std::vector<std::uint8_t>& near) const;
  void spread(int axis);
  void spread_everywhere();
  bool moved_far() const;

  int dimension_ = 3;
  double far_limit_ = 0.0;  // units, of the motion of all points together
  bool local_ = true;
  GridShape coarse_;
  std::vector<std::uint32_t> order_;  // owned points by coarse cell
  std::vector<std::uint32_t> start_;  // [coarse cell]
  std::array<std::vector<Units>, 3> reference_;
  std::vector<std::uint8_t> near_wall_, near_fluid_;
  Boxes own_, around_, scratch_;
};

}  // namespace moraine
