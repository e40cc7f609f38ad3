#include "search/displacement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"

namespace moraine {
namespace {

constexpr float nothing = std::numeric_limits<float>::infinity();

std::size_t bytes_of(std::vector<float> const& v) { return v.capacity() * sizeof(float); }

}  // namespace

std::size_t DisplacementBound::coarse_cell(UnitPoint const& x) const {
  int c[3] = {0, 0, 0};
  for (int axis = 0; axis < dimension_; ++axis)
    c[axis] = coarse_.along(x[static_cast<std::size_t>(axis)], axis);
  return coarse_.index(c[0], c[1], c[2]);
}

void DisplacementBound::reset(CellPoints const& fluid, CellPoints const& walls, std::size_t owned,
                              double radius, bool local, UnitSpans const& positions) {
  dimension_ = fluid.grid.dimension;
  GridShape const& fine = fluid.grid.shape;
  double const coarse_edge = 1.5 * radius;
  far_limit_ = coarse_edge - radius;
  local_ = local;
  // The same box as the fine grid, in cells that no pair within the radius can skip.
  UnitPoint low{}, high{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    double const extent = fine.edge * fine.cells[axis];
    low[axis] = static_cast<Units>(fine.origin[axis]);
    high[axis] = static_cast<Units>(std::min(2147483000.0, low[axis] + extent));
  }
  // No more cells than the fine grid has, however far single particles lie from the others.
  std::size_t const most_cells = std::max<std::size_t>(4096, fine.size());
  coarse_ = GridShape::over(low, high, dimension_, coarse_edge, most_cells);

  auto const at = [&](auto const& x, std::size_t i) {
    UnitPoint p{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
      p[axis] = x[axis][i];
    return p;
  };
  start_.assign(coarse_.size() + 1, 0);
  order_.resize(owned);
  for (std::size_t i = 0; i < owned; ++i) ++start_[coarse_cell(at(positions, i)) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  for (std::size_t i = 0; i < owned; ++i)
    order_[start_[coarse_cell(at(positions, i))]++] = static_cast<std::uint32_t>(i);
  for (std::size_t c = coarse_.size(); c > 0; --c) start_[c] = start_[c - 1];
  start_[0] = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
    reference_[axis].assign(positions[axis].begin(),
                            positions[axis].begin() + static_cast<std::ptrdiff_t>(owned));

  mark(walls, near_wall_);
  mark(fluid, near_fluid_);
}

/// Marks the coarse cells of points and all cells around them.
void DisplacementBound::mark(CellPoints const& points, std::vector<std::uint8_t>& near) const {
  near.assign(coarse_.size(), 0);
  for (std::size_t k = 0; k < points.grid.size(); ++k) {
    UnitPoint x{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
      x[axis] = points.x[axis][k];
    near[coarse_cell(x)] = 1;
  }
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

void DisplacementBound::collect(UnitSpans const& positions) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    own_.low[axis].resize(coarse_.size());
    own_.high[axis].resize(coarse_.size());
  }
  for_each_block(coarse_.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
      auto const now = positions[axis];
      auto const& before = reference_[axis];
      for (std::size_t c = begin; c < end; ++c) {
        float low = nothing;
        float high = -nothing;
        for (std::uint32_t k = start_[c]; k < start_[c + 1]; ++k) {
          auto const moved = static_cast<float>(now[order_[k]] - before[order_[k]]);
          low = std::min(low, moved);
          high = std::max(high, moved);
        }
        own_.low[axis][c] = low;
        own_.high[axis][c] = high;
      }
    }
  });
}

/// One pass of a separable minimum / maximum filter over three cells along an axis.
void DisplacementBound::spread(int axis) {
  auto const cells = [&](int a) {
    return static_cast<std::size_t>(coarse_.cells[static_cast<std::size_t>(a)]);
  };
  std::size_t const step = axis == 0 ? 1 : (axis == 1 ? cells(0) : cells(0) * cells(1));
  std::size_t const along = cells(axis);
  for (std::size_t component = 0; component < static_cast<std::size_t>(dimension_); ++component) {
    auto& low = around_.low[component];
    auto& high = around_.high[component];
    scratch_.low[component].resize(coarse_.size());
    scratch_.high[component].resize(coarse_.size());
    for_each_block(coarse_.size(), loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        std::size_t const place = c / step % along;
        std::size_t const back = place > 0 ? c - step : c;
        std::size_t const next = place + 1 < along ? c + step : c;
        scratch_.low[component][c] = std::min({low[back], low[c], low[next]});
        scratch_.high[component][c] = std::max({high[back], high[c], high[next]});
      }
    });
    low.swap(scratch_.low[component]);
    high.swap(scratch_.high[component]);
  }
}

void DisplacementBound::spread_everywhere() {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    auto& low = around_.low[axis];
    auto& high = around_.high[axis];
    std::fill(low.begin(), low.end(), *std::min_element(low.begin(), low.end()));
    std::fill(high.begin(), high.end(), *std::max_element(high.begin(), high.end()));
  }
}

DisplacementBound::Largest DisplacementBound::largest(UnitSpans const& positions) {
  collect(positions);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    around_.low[axis].assign(own_.low[axis].begin(), own_.low[axis].end());
    around_.high[axis].assign(own_.high[axis].begin(), own_.high[axis].end());
  }
  if (local_)
    for (int axis = 0; axis < dimension_; ++axis) spread(axis);
  else
    spread_everywhere();

  auto const of_cells = [&](std::size_t begin, std::size_t end) {
    Largest most;
    for (std::size_t c = begin; c < end; ++c) {
      if (start_[c] == start_[c + 1]) continue;
      double relative2 = 0.0;
      double moved2 = 0.0;
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
        float const low = own_.low[axis][c];
        float const high = own_.high[axis][c];
        double const relative = std::max(around_.high[axis][c] - low, high - around_.low[axis][c]);
        double const moved = std::max(std::fabs(low), std::fabs(high));
        relative2 += relative * relative;
        moved2 += moved * moved;
      }
      most.fluid = std::max(most.fluid, relative2);
      if (near_wall_[c] != 0) most.wall = std::max(most.wall, moved2);
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

/// True when some point has moved, or two points have moved against each other, by more than the
/// gap that cells which do not touch are sure to leave.
bool DisplacementBound::moved_far() const {
  double relative2 = 0.0;
  double moved2 = 0.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    double const low = *std::min_element(own_.low[axis].begin(), own_.low[axis].end());
    double const high = *std::max_element(own_.high[axis].begin(), own_.high[axis].end());
    double const moved = std::max(std::fabs(low), std::fabs(high));
    relative2 += (high - low) * (high - low);
    moved2 += moved * moved;
  }
  return !(std::max(relative2, moved2) < far_limit_ * far_limit_);
}

std::size_t DisplacementBound::bytes() const {
  std::size_t sum =
      (order_.capacity() + start_.capacity()) * 4 + near_wall_.capacity() + near_fluid_.capacity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum += reference_[axis].capacity() * sizeof(Units);
    for (Boxes const* boxes : {&own_, &around_, &scratch_})
      sum += bytes_of(boxes->low[axis]) + bytes_of(boxes->high[axis]);
  }
  return sum;
}

}  // namespace moraine
