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
#include "search/cell_motion.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// Positions [axis][point] in units; walls only where they move.
struct MovingPoints {
  UnitSpans fluid;
  UnitSpans walls;
};

class DisplacementBound {
 public:
  struct Reach {
    double radius = 0.0;  // units, of the lists
    // Neighbours may lie across a periodic side, so the bound is taken over all cells.
    bool across_sides = false;
    // Planes, whose images move the other way, by axis and end; units, infinite where none is.
    MirrorPlaces planes = no_planes();
  };

  /// Takes the reference positions, sorted along the grid of `fluid`, and where fluid and walls
  /// are, images included.
  void reset(CellPoints const& fluid, CellPoints const& walls, Reach const& reach,
             MovingPoints const& positions);

  /// Largest possible relative displacement [units] of two neighbouring points; infinite when
  /// points of cells that do not touch may have come near each other.
  struct Largest {
    double fluid = 0.0;  // two fluid points
    double wall = 0.0;   // a fluid point and a wall point
  };
  Largest largest(MovingPoints const& positions);

  /// Reference positions along one axis, in the order of the points.
  std::span<Units const> reference(Kind kind, std::size_t axis) const {
    return kind == Kind::fluid ? fluid_.reference(axis) : walls_.reference(axis);
  }

  /// False where no wall point, or no fluid point, can be a neighbour of a point here.
  bool near_wall(UnitPoint const& x) const { return near_wall_[coarse_cell(x)] != 0; }
  bool near_fluid(UnitPoint const& x) const { return near_fluid_[coarse_cell(x)] != 0; }

  /// No point has moved farther than this [units] since `reset` while `largest` is finite.
  double longest_motion() const { return far_limit_; }

  std::size_t bytes() const;

 private:
  std::size_t coarse_cell(UnitPoint const& x) const { return cell_of(coarse_, dimension_, x); }
  void shape_coarse(CellGrid const& fine, double radius);
  void mark(CellPoints const& points, std::vector<std::uint8_t>& near) const;
  Largest largest_in(std::size_t cell) const;
  bool moved_far() const;

  int dimension_ = 3;
  double far_limit_ = 0.0;  // units, of the motion of all points together
  Reach reach_;
  GridShape coarse_;
  std::vector<std::uint8_t> near_wall_, near_fluid_;
  CellMotion fluid_, walls_;
};

}  // namespace moraine
