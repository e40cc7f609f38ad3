#include "search/neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/simd_memory.hpp"

namespace moraine {

namespace {

/// Replaces the content, with a little slack instead of the usual doubling: lists are most of the
/// memory of a run.
template <class T>
void assign_tightly(std::vector<T>& to, std::vector<T> const& from) {
  if (to.capacity() < from.size()) {
    std::vector<T>().swap(to);
    to.reserve(from.size() + from.size() / 32);
  }
  to.assign(from.begin(), from.end());
}

}  // namespace

void NeighbourList::encode(std::span<std::uint32_t> points, Scratch& scratch) const {
  for (std::size_t k = 0; k < points.size();) {
    std::uint32_t const base = slot_of(points[k]);
    std::size_t const room = std::min(lanes_, points.size() - k);
    std::size_t taken = room;
    while (slot_of(points[k + taken - 1]) - base > 0xFFFFu) --taken;
    std::size_t const first = scratch.offsets.size();
    scratch.offsets.resize(first + lanes_);
    std::uint16_t* const out = scratch.offsets.data() + first;
    std::uint32_t const* const in = points.data() + k;
    for (std::size_t lane = 0; lane < taken; ++lane)
      out[lane] = static_cast<std::uint16_t>(slot_of(in[lane]) - base);
    for (std::size_t lane = taken; lane < lanes_; ++lane)
      out[lane] = static_cast<std::uint16_t>(nowhere_after(base) - base);
    scratch.bases.push_back(base);
    k += taken;
  }
}

void NeighbourList::store(Block& to, Scratch const& scratch) const {
  assign_tightly(to.bases, scratch.bases);
  assign_tightly(to.offsets, scratch.offsets);
}

std::vector<std::uint32_t> NeighbourList::points(std::size_t i) const {
  std::vector<std::uint32_t> found;
  NeighbourGroups const groups = of(i);
  for (std::size_t k = 0; k < groups.count * lanes_; ++k) {
    std::uint32_t const slot = groups.bases[k / lanes_] + groups.offsets[k];
    if (!is_nowhere(slot)) found.push_back(point_at(slot));
  }
  return found;
}

std::size_t NeighbourList::bytes() const {
  std::size_t sum = 0;
  for (Block const& b : blocks_)
    sum += (b.bases.capacity() + b.start.capacity()) * sizeof(std::uint32_t) +
           b.offsets.capacity() * sizeof(std::uint16_t);
  for (Scratch const& scratch : scratch_)
    sum += scratch.candidates.bytes() + scratch.found.bytes() +
           scratch.bases.capacity() * sizeof(std::uint32_t) +
           scratch.offsets.capacity() * sizeof(std::uint16_t);
  return sum;
}

template <int D>
NeighbourFinder<D>::NeighbourFinder(CellPoints const& points, double radius, PairRadius of_pair,
                                    float skin, float least)
    : points_(points),
      radius_(radius),
      // Squares are compared in single precision; the margin covers its rounding.
      radius2_(static_cast<float>(radius * radius * (1.0 + 1e-6))),
      of_pair_(of_pair),
      skin_(skin),
      least_(least) {}

/// Squares of the radii of pairs with the next candidates.
template <int D>
template <class Float>
Float NeighbourFinder<D>::radius_squared(float support, float const* supports) const {
  if (of_pair_ == PairRadius::same) return Float(radius2_);
  Float radius(std::max(support, least_) + skin_);
  if (of_pair_ != PairRadius::of_self) {
    Float const other = Float::load(supports);
    if (of_pair_ == PairRadius::of_other) radius = maximum(other, Float(least_)) + Float(skin_);
    if (of_pair_ == PairRadius::mean)
      radius = Float(0.5F) * (Float(support) + other) + Float(skin_);
    if (of_pair_ == PairRadius::larger) radius = maximum(Float(support), other) + Float(skin_);
  }
  // The margin covers the rounding of single precision.
  return radius * radius * Float(1.0F + 2e-6F);
}

template <int D>
void NeighbourFinder<D>::gather(std::array<int, 3> const& cell, CandidateCache& cache) const {
  GridShape const& shape = points_.grid.shape;
  auto const& start = points_.grid.start;
  cache.cell = cell;
  cache.valid = true;
  cache.count = 0;
  std::array<double, 3> low{}, high{};  // the cell, a hair larger for rounding
  for (std::size_t axis = 0; axis < D; ++axis) {
    low[axis] = shape.origin[axis] + shape.edge * cell[axis] - 2.0;
    high[axis] = low[axis] + shape.edge + 4.0;
  }
  auto const range = [&](int axis, double reach) {
    auto const k = static_cast<std::size_t>(axis);
    return std::array<int, 2>{shape.along(low[k] - reach, axis),
                              shape.along(high[k] + reach, axis)};
  };
  // Square of the gap between the cell and a row of cells along one axis.
  auto const gap2 = [&](std::size_t axis, int row) {
    double const row_low = shape.origin[axis] + shape.edge * row;
    double const gap = std::max({row_low - high[axis], low[axis] - row_low - shape.edge, 0.0});
    return gap * gap;
  };
  std::array<int, 2> const ys = D > 1 ? range(1, radius_) : std::array<int, 2>{0, 0};
  std::array<int, 2> const zs = D > 2 ? range(2, radius_) : std::array<int, 2>{0, 0};
  for (int cz = zs[0]; cz <= zs[1]; ++cz) {
    for (int cy = ys[0]; cy <= ys[1]; ++cy) {
      double const half2 =
          radius_ * radius_ - (D > 2 ? gap2(2, cz) : 0.0) - (D > 1 ? gap2(1, cy) : 0.0);
      if (half2 < 0.0) continue;
      auto const xs = range(0, std::sqrt(half2));
      std::size_t const first = shape.index(0, cy, cz);
      std::size_t const begin = start[first + static_cast<std::size_t>(xs[0])];
      std::size_t const end = start[first + static_cast<std::size_t>(xs[1]) + 1];
      std::size_t const needed = cache.count + (end - begin) + CellPoints::padding;
      if (cache.index.size() < needed) {
        cache.index.resize(2 * needed);
        for (auto& axis : cache.x) axis.resize(2 * needed);
        if (asks_supports()) cache.support.resize(2 * needed);
      }
      std::uint32_t* const index = cache.index.data() + cache.count;
      if (points_.index.empty())
        std::iota(index, index + (end - begin), static_cast<std::uint32_t>(begin));
      else
        copy_in_vectors(points_.index.data() + begin, end - begin, index);
      for (std::size_t axis = 0; axis < D; ++axis)
        copy_in_vectors(points_.x[axis].data() + begin, end - begin,
                        cache.x[axis].data() + cache.count);
      if (asks_supports())
        std::copy_n(points_.support.data() + begin, end - begin,
                    cache.support.data() + cache.count);
      cache.count += end - begin;
    }
  }
}

template <int D>
void NeighbourFinder<D>::operator()(UnitPoint const& x, std::uint32_t self, CandidateCache& cache,
                                    IndexBuffer& buffer, float support) const {
  constexpr std::size_t width = widest_float < 8 ? 4 : (D == 3 ? widest_float : 8);
  using Float = Simd<float, width>;
  using Int = Simd<std::int32_t, width>;
  GridShape const& shape = points_.grid.shape;
  std::array<int, 3> cell{};  // not clamped: x may lie outside of the grid
  for (std::size_t axis = 0; axis < D; ++axis)
    cell[axis] = static_cast<int>(std::floor((x[axis] - shape.origin[axis]) * shape.inverse_edge));
  if (!cache.valid || cell != cache.cell) gather(cell, cache);

  std::uint32_t* const out = buffer.room(cache.count + width);
  std::size_t found = 0;
  for (std::size_t k = 0; k < cache.count; k += width) {
    Float distance2(0.0f);
    for (std::size_t axis = 0; axis < D; ++axis) {
      Float const difference = convert<float>(Int(x[axis]) - Int::load(cache.x[axis].data() + k));
      distance2 += difference * difference;
    }
    unsigned mask =
        bits_less(distance2,
                  radius_squared<Float>(support, cache.support.data() + (asks_supports() ? k : 0)));
    if (cache.count - k < width) mask &= (1u << (cache.count - k)) - 1u;
    mask &= ~bits_equal<width>(cache.index.data() + k, self);
    found +=
        static_cast<std::size_t>(compress_store<width>(out + found, cache.index.data() + k, mask));
  }
  buffer.advance(found);
}

template class NeighbourFinder<1>;
template class NeighbourFinder<2>;
template class NeighbourFinder<3>;

}  // namespace moraine
