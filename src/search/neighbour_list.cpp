#include "search/neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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
    sum += scratch.found.bytes() + scratch.bases.capacity() * sizeof(std::uint32_t) +
           scratch.offsets.capacity() * sizeof(std::uint16_t);
  return sum;
}

template <int D>
RowCollector<D>::RowCollector(CellGrid const& grid, double radius)
    : grid_(grid),
      radius_(radius),
      // Squares are compared in single precision; the margin covers its rounding.
      radius2_(static_cast<float>(radius * radius * (1.0 + 1e-6))) {}

template <int D>
void RowCollector<D>::row(UnitPoint const& x, std::uint32_t self, std::size_t begin,
                          std::size_t end, IndexBuffer& buffer) const {
  constexpr std::size_t width = widest_float < 8 ? 4 : (D == 3 ? widest_float : 8);
  using Float = Simd<float, width>;
  using Int = Simd<std::int32_t, width>;
  std::uint32_t* const out = buffer.room(end - begin + width);
  std::size_t found = 0;
  for (std::size_t k = begin; k < end; k += width) {
    Float distance2(0.0f);
    for (std::size_t axis = 0; axis < D; ++axis) {
      Float const difference = convert<float>(Int(x[axis]) - Int::load(grid_.x[axis].data() + k));
      distance2 += difference * difference;
    }
    unsigned mask = bits_less(distance2, Float(radius2_));
    if (end - k < width) mask &= (1u << (end - k)) - 1u;
    mask &= ~bits_equal<width>(grid_.entry.data() + k, self);
    found +=
        static_cast<std::size_t>(compress_store<width>(out + found, grid_.entry.data() + k, mask));
  }
  buffer.advance(found);
}

template <int D>
void RowCollector<D>::operator()(UnitPoint const& x, std::uint32_t self,
                                 IndexBuffer& buffer) const {
  GridShape const& shape = grid_.shape;
  // Square of the distance from x to a row of cells along one axis, taken short by a few units for
  // rounding: a row too many costs nothing but time.
  auto const gap2 = [&](std::size_t axis, int cell) {
    double const low = shape.origin[axis] + shape.edge * cell - x[axis];
    double const gap = std::max({low, -low - shape.edge, 2.0}) - 2.0;
    return gap * gap;
  };
  auto const range = [&](int axis, double reach) {
    double const at = x[static_cast<std::size_t>(axis)];
    return std::array<int, 2>{shape.along(at - reach, axis), shape.along(at + reach, axis)};
  };
  std::array<int, 2> const ys = D > 1 ? range(1, radius_) : std::array<int, 2>{0, 0};
  std::array<int, 2> const zs = D > 2 ? range(2, radius_) : std::array<int, 2>{0, 0};
  for (int cz = zs[0]; cz <= zs[1]; ++cz) {
    double const left2 = radius_ * radius_ - (D > 2 ? gap2(2, cz) : 0.0);
    for (int cy = ys[0]; cy <= ys[1]; ++cy) {
      double const half2 = left2 - (D > 1 ? gap2(1, cy) : 0.0);
      if (half2 < 0.0) continue;
      auto const xs = range(0, std::sqrt(half2) + 2.0);
      std::size_t const first = shape.index(0, cy, cz);
      row(x, self, grid_.start[first + static_cast<std::size_t>(xs[0])],
          grid_.start[first + static_cast<std::size_t>(xs[1]) + 1], buffer);
    }
  }
}

template class RowCollector<1>;
template class RowCollector<2>;
template class RowCollector<3>;

}  // namespace moraine
