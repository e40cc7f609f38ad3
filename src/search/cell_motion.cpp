#include "search/cell_motion.hpp"

#include <algorithm>

#include "base/parallel_for.hpp"

namespace moraine {

std::size_t MotionBoxes::bytes() const {
  std::size_t sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum += (low[axis].capacity() + high[axis].capacity()) * sizeof(float);
  return sum;
}

void CellMotion::reset(GridShape const& coarse, int dimension, UnitSpans const& positions) {
  coarse_ = coarse;
  dimension_ = dimension;
  std::size_t const count = positions[0].size();
  auto const cell = [&](std::size_t i) {
    return cell_of(coarse_, dimension_, point_of(positions, dimension_, i));
  };
  start_.assign(coarse_.size() + 1, 0);
  order_.resize(count);
  for (std::size_t i = 0; i < count; ++i) ++start_[cell(i) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  for (std::size_t i = 0; i < count; ++i) order_[start_[cell(i)]++] = static_cast<std::uint32_t>(i);
  for (std::size_t c = coarse_.size(); c > 0; --c) start_[c] = start_[c - 1];
  start_[0] = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
    reference_[axis].assign(positions[axis].begin(), positions[axis].end());
}

void CellMotion::collect(UnitSpans const& positions, bool local, MirrorPlaces const& planes,
                         double reach) {
  collect_own(positions);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    around_.low[axis].assign(own_.low[axis].begin(), own_.low[axis].end());
    around_.high[axis].assign(own_.high[axis].begin(), own_.high[axis].end());
  }
  if (!local) return spread_everywhere(planes);
  for (int axis = 0; axis < dimension_; ++axis) spread(axis);
  reflect(planes, reach);
}

void CellMotion::reflect(MirrorPlaces const& planes, double reach) {
  std::size_t step = 1;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    auto const along = static_cast<std::size_t>(coarse_.cells[axis]);
    for (std::size_t place = 0; place < along; ++place) {
      double const low = coarse_.origin[axis] + coarse_.edge * static_cast<double>(place);
      double const high = low + coarse_.edge;
      if (low > planes[axis][0] + reach && high < planes[axis][1] - reach) continue;
      for (std::size_t first = place * step; first < coarse_.size(); first += step * along)
        for (std::size_t c = first; c < first + step; ++c) {
          MotionRange range = around(axis, c);
          range.include({-range.high, -range.low});
          around_.low[axis][c] = range.low;
          around_.high[axis][c] = range.high;
        }
    }
    step *= along;
  }
}

void CellMotion::collect_own(UnitSpans const& positions) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    own_.low[axis].resize(coarse_.size());
    own_.high[axis].resize(coarse_.size());
  }
  for_each_block(coarse_.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
      auto const now = positions[axis];
      auto const& before = reference_[axis];
      for (std::size_t c = begin; c < end; ++c) {
        float low = MotionBoxes::nothing;
        float high = -MotionBoxes::nothing;
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
void CellMotion::spread(int axis) {
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

void CellMotion::spread_everywhere(MirrorPlaces const& planes) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    MotionRange range = all(axis);
    if (planes[axis] != no_planes()[axis]) range.include({-range.high, -range.low});
    std::fill(around_.low[axis].begin(), around_.low[axis].end(), range.low);
    std::fill(around_.high[axis].begin(), around_.high[axis].end(), range.high);
  }
}

MotionRange CellMotion::all(std::size_t axis) const {
  if (empty()) return {};
  return {*std::min_element(own_.low[axis].begin(), own_.low[axis].end()),
          *std::max_element(own_.high[axis].begin(), own_.high[axis].end())};
}

std::size_t CellMotion::bytes() const {
  std::size_t sum = (order_.capacity() + start_.capacity()) * sizeof(std::uint32_t) + own_.bytes() +
                    around_.bytes() + scratch_.bytes();
  for (auto const& axis : reference_) sum += axis.capacity() * sizeof(Units);
  return sum;
}

}  // namespace moraine
