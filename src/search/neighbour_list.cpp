#include "search/neighbour_list.hpp"

#include <cmath>

#include "base/simd.hpp"

namespace moraine {

void NeighbourList::store(std::size_t index, std::span<std::uint32_t const> indices) {
  auto& stored = blocks_[index].indices;
  // A little slack instead of the usual doubling: lists are most of the memory of a run.
  if (stored.capacity() < indices.size()) {
    std::vector<std::uint32_t>().swap(stored);
    stored.reserve(indices.size() + indices.size() / 32);
  }
  stored.assign(indices.begin(), indices.end());
}

std::size_t NeighbourList::bytes() const {
  std::size_t words = 0;
  for (Block const& b : blocks_) words += b.indices.capacity() + b.start.capacity();
  std::size_t sum = words * sizeof(std::uint32_t);
  for (IndexBuffer const& buffer : scratch_) sum += buffer.bytes();
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
      Float const difference =
          convert<float>(Int(x[axis]) - Int::load(grid_.x[axis].data() + k));
      distance2 += difference * difference;
    }
    unsigned mask = bits_less(distance2, Float(radius2_));
    if (end - k < width) mask &= (1u << (end - k)) - 1u;
    mask &= ~bits_equal<width>(grid_.entry.data() + k, self);
    found += static_cast<std::size_t>(
        compress_store<width>(out + found, grid_.entry.data() + k, mask));
  }
  buffer.advance(found);
}

template <int D>
void RowCollector<D>::operator()(UnitPoint const& x, std::uint32_t self,
                                 IndexBuffer& buffer) const {
  GridShape const& shape = grid_.shape;
  // Distance from x to the near side of a row of cells; a hair is taken off for rounding.
  auto const gap = [&](int axis, int cell) {
    auto const k = static_cast<std::size_t>(axis);
    double const low = shape.origin[k] + shape.edge * cell - 1.0;
    double const high = low + shape.edge + 2.0;
    double const at = x[k];
    return at < low ? low - at : (at > high ? at - high : 0.0);
  };
  auto const range = [&](int axis, double reach) {
    double const at = x[static_cast<std::size_t>(axis)];
    return std::array<int, 2>{shape.along(at - reach, axis), shape.along(at + reach, axis)};
  };
  std::array<int, 2> const ys = D > 1 ? range(1, radius_) : std::array<int, 2>{0, 0};
  std::array<int, 2> const zs = D > 2 ? range(2, radius_) : std::array<int, 2>{0, 0};
  for (int cz = zs[0]; cz <= zs[1]; ++cz) {
    double const dz = D > 2 ? gap(2, cz) : 0.0;
    for (int cy = ys[0]; cy <= ys[1]; ++cy) {
      double const dy = D > 1 ? gap(1, cy) : 0.0;
      double const half2 = radius_ * radius_ - dy * dy - dz * dz;
      if (half2 < 0.0) continue;
      auto const xs = range(0, std::sqrt(half2) + 1.0);
      row(x, self, grid_.start[shape.index(xs[0], cy, cz)],
          grid_.start[shape.index(xs[1], cy, cz) + 1], buffer);
    }
  }
}

template class RowCollector<1>;
template class RowCollector<2>;
template class RowCollector<3>;

}  // namespace moraine
