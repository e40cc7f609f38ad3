#include "search/displacement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"

namespace moraine {

void DisplacementBound::reset(CellPoints const& fluid, CellPoints const& walls, Reach const& reach,
                              MovingPoints const& positions) {
  dimension_ = fluid.grid.dimension;
  reach_ = reach;
  shape_coarse(fluid.grid, reach.radius);
  fluid_.reset(coarse_, dimension_, positions.fluid);
  walls_.reset(coarse_, dimension_, positions.walls);
  mark(walls, near_wall_);
  mark(fluid, near_fluid_);
}

/// The same box as the fine grid, in cells that no pair within the radius can skip.
void DisplacementBound::shape_coarse(CellGrid const& fine, double radius) {
  double const coarse_edge = 1.5 * radius;
  far_limit_ = coarse_edge - radius;
  UnitPoint low{}, high{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    double const extent = fine.shape.edge * fine.shape.cells[axis];
    low[axis] = static_cast<Units>(fine.shape.origin[axis]);
    high[axis] = static_cast<Units>(std::min(2147483000.0, low[axis] + extent));
  }
  // No more cells than the fine grid has, however far single particles lie from the others.
  std::size_t const most_cells = std::max<std::size_t>(4096, fine.shape.size());
  coarse_ = GridShape::over(low, high, dimension_, coarse_edge, most_cells);
}

/// Marks the coarse cells of points and all cells around them.
void DisplacementBound::mark(CellPoints const& points, std::vector<std::uint8_t>& near) const {
  near.assign(coarse_.size(), 0);
  for (std::size_t k = 0; k < points.grid.size(); ++k)
    near[coarse_cell(point_of(points.x, dimension_, k))] = 1;
  std::size_t step = 1;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    auto const along = static_cast<std::size_t>(coarse_.cells[axis]);
    std::uint8_t before = 0;  // mark of the cell one step back, as it was
    for (std::size_t first = 0; first < coarse_.size(); first += step * along)
      for (std::size_t offset = 0; offset < step; ++offset) {
        before = 0;
        for (std::size_t place = 0; place < along; ++place) {
          std::size_t const c = first + offset + place * step;
          std::uint8_t const here = near[c];
          std::uint8_t const next = place + 1 < along ? near[c + step] : std::uint8_t{0};
          near[c] = before | here | next;
          before = here;
        }
      }
    step *= along;
  }
}

DisplacementBound::Largest DisplacementBound::largest(MovingPoints const& positions) {
  bool const local = !reach_.across_sides;
  fluid_.collect(positions.fluid, local, reach_.planes, reach_.radius);
  if (!walls_.empty()) walls_.collect(positions.walls, local, reach_.planes, reach_.radius);
  auto const of_cells = [&](std::size_t begin, std::size_t end) {
    Largest most;
    for (std::size_t c = begin; c < end; ++c) {
      if (fluid_.empty(c)) continue;
      Largest const here = largest_in(c);
      most.fluid = std::max(most.fluid, here.fluid);
      if (near_wall_[c] != 0) most.wall = std::max(most.wall, here.wall);
    }
    return most;
  };
  Largest const most = reduce_blocks(coarse_.size(), Largest{}, of_cells, [](Largest a, Largest b) {
    return Largest{std::max(a.fluid, b.fluid), std::max(a.wall, b.wall)};
  });
  if (moved_far())
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  return {std::sqrt(most.fluid), std::sqrt(most.wall)};
}

/// Squares of the largest relative displacements of the fluid in a cell and what is around.
DisplacementBound::Largest DisplacementBound::largest_in(std::size_t cell) const {
  Largest squares;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    MotionRange const own = fluid_.own(axis, cell);
    auto const against = [&own](MotionRange const& other) {
      double const most = std::max(other.high - own.low, own.high - other.low);
      return std::max(most, 0.0);
    };
    double const fluid = against(fluid_.around(axis, cell));
    double const wall =
        against(walls_.empty() ? MotionRange{0.0F, 0.0F} : walls_.around(axis, cell));
    squares.fluid += fluid * fluid;
    squares.wall += wall * wall;
  }
  return squares;
}

/// True when two points, or a point and a wall at rest, have moved against each other by more than
/// the gap that cells which do not touch are sure to leave.
bool DisplacementBound::moved_far() const {
  double relative2 = 0.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    MotionRange range = fluid_.all(axis);
    range.include(walls_.all(axis));
    range.include({0.0F, 0.0F});
    if (reach_.planes[axis] != no_planes()[axis]) range.include({-range.high, -range.low});
    double const relative = range.high - range.low;
    relative2 += relative * relative;
  }
  return !(relative2 < far_limit_ * far_limit_);
}

std::size_t DisplacementBound::bytes() const {
  return near_wall_.capacity() + near_fluid_.capacity() + fluid_.bytes() + walls_.bytes();
}

}  // namespace moraine
