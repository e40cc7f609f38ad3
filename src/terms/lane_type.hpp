// Number types of the lanes of a pair loop.
#pragma once

#include <algorithm>
#include <type_traits>

#include "base/simd.hpp"
#include "search/neighbour_list.hpp"
#include "terms/pair_backend.hpp"

namespace moraine {

/// Number type of the lanes. Short lists (1D, 2D) waste fewer lanes with half-width registers.
template <int D, Flavour flavour>
struct LaneType {
  static constexpr std::size_t floats = std::min(widest_float, NeighbourList::lanes(D));
  using Slot = std::conditional_t<flavour == Flavour::mixed, float, double>;
  using Real = std::conditional_t<flavour == Flavour::mixed, Simd<float, floats>,
                                  Simd<double, (widest_float / 2 < 4 ? 2 : widest_float / 2)>>;
};

}  // namespace moraine
