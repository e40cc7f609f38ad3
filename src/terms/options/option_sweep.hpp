// The loop over pairs of the optional terms: that of terms/sweep.hpp for terms that make their sums
// themselves, and for sums that come before forces.
#pragma once

#include <cstdint>
#include <tuple>

#include "smoothing/pair_smoothing.hpp"
#include "terms/options/option_pair.hpp"
#include "terms/sweep.hpp"

namespace moraine {

/// Who looks at whom: the one that sums, then its neighbours.
enum class Pairing : std::uint8_t { fluid_fluid, fluid_wall, wall_fluid };

template <class Real, int D>
using OptionConstants = SweepConstants<Real, D, AnyKernel<D>>;

/// Smoothing length of a pair, as in the main sweep.
template <Pairing pairing, class Real, int D, class Self, class Neighbour>
MORAINE_FORMULA Real option_smoothing(OptionConstants<Real, D> const& constants, Self const& i,
                                      Neighbour const& j) {
  if constexpr (pairing == Pairing::fluid_fluid)
    return pair_smoothing(constants.of_pair, smoothing_length(i), smoothing_length(j));
  else if constexpr (pairing == Pairing::fluid_wall)
    return maximum(smoothing_length(i), constants.scale.h);
  else
    return maximum(smoothing_length(j), constants.scale.h);
}

/// A pair at separation x [m].
template <Pairing pairing, class Real, int D, class Self, class Neighbour>
MORAINE_FORMULA OptionPair<Real, D> option_pair(OptionConstants<Real, D> const& constants,
                                                Self const& i, Neighbour const& j,
                                                Real const (&x)[D]) {
  OptionPair<Real, D> pair;
  pair.distance2 = number<Real>(0);
  for (int axis = 0; axis < D; ++axis) {
    pair.x[axis] = x[axis];
    pair.distance2 += x[axis] * x[axis];
    pair.v[axis] = velocity(i, axis) - velocity(j, axis);
  }
  pair.h = option_smoothing<pairing, Real, D>(constants, i, j);
  auto const scale = PairScale<Real>::template of<D>(pair.h, constants.sigma);
  Real const q = square_root(pair.distance2 * scale.inverse_h2);
  pair.kernel = scale.gradient_factor * pair.h * pair.h * constants.kernel.shape(q);
  pair.gradient = scale.gradient_factor * constants.kernel.slope_over_q(q);
  return pair;
}

/// Adds the neighbours in one list to `total`, by all of `terms`.
template <Pairing pairing, class Layout, class Real, int D, class Self, class Terms, class Sum>
[[gnu::noinline]] void sum_options(OptionConstants<Real, D> const& constants, Self const& self,
                                   NeighbourGroups const& list, SlotOf<Real> const* records,
                                   Terms const& terms, Sum& total) {
  constexpr bool wall = pairing == Pairing::fluid_wall;
  Sum sum = total;
  Lanes<Real, Layout> lanes;
  lanes.uniform = self.uniform;
  for_each_lanes(
      list, records, lanes, [&]() __attribute__((always_inline)) {
        Real x[D];
        for (int axis = 0; axis < D; ++axis)
          x[axis] = separation(self.position(axis), lanes.packed[axis], constants.position_scale);
        auto const pair = option_pair<pairing, Real, D>(constants, self, lanes, x);
        std::apply(
            [&](auto const&... term) __attribute__((always_inline)) {
              (term.template add<wall>(pair, self, lanes, sum), ...);
            },
            terms);
      });
  total = sum;
}

}  // namespace moraine
