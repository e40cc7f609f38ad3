// The loop over particle pairs.
//
// For each particle i the sweep walks its neighbour list W lanes at a time, turns the records of
// the neighbours into lanes, forms the pair geometry, calls all terms, and adds up. It is the only
// place where pairs are looped over with SIMD; `reference_sweep` beside it is the same loop written
// plainly in scalar double, and tests hold one against the other.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>

#include "base/simd_memory.hpp"
#include "search/neighbour_list.hpp"
#include "smoothing/any_kernel.hpp"
#include "smoothing/pair_smoothing.hpp"
#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"
#include "terms/sweep_parameters.hpp"

namespace moraine {

/// What the sweep adds up for one particle.
template <class Real, int D>
struct PairSum {
  Real acceleration[D];
  Real density_rate;
  Real energy_rate;
  Real approach_speed;  // most negative mu_ij [m/s]
};

/// x_i - x_j along one axis: exact for fixed-point records (Slot float), plain for double.
template <class Real>
MORAINE_FORMULA Real separation(SlotOf<Real> x_i, Real x_j, Real scale) {
  if constexpr (std::is_same_v<SlotOf<Real>, float>) {
    using Integers = Simd<std::int32_t, Real::size()>;
    return convert<float>(Integers(std::bit_cast<std::int32_t>(x_i)) -
                          __builtin_bit_cast(Integers, x_j)) *
           scale;
  } else {
    return Real(x_i) - x_j;
  }
}

/// What the smoothing length of a pair makes: h [m], 1/h^2, sigma_d / h^(d+2), and phi^2 = (0.1
/// h)^2, which keeps 1 / r^2 finite for close pairs.
template <class Real>
struct PairScale {
  Real h;
  Real inverse_h2;
  Real gradient_factor;
  Real softening2;

  template <int D>
  MORAINE_FORMULA static PairScale of(Real const& h, Real const& sigma) {
    Real const inverse = number<Real>(1) / h;
    Real const inverse2 = inverse * inverse;
    Real const inverse_d = D == 1 ? inverse : (D == 2 ? inverse2 : inverse2 * inverse);
    return {h, inverse2, sigma * inverse_d * inverse2, number<Real>(0.01) * h * h};
  }
};

/// Everything that does not change from particle to particle, in lanes.
template <class Real, int D, class Kernel>
struct SweepConstants {
  explicit SweepConstants(SweepParameters const& p)
      : kernel(make_kernel<Kernel>(p.kernel)),
        of_pair(p.of_pair),
        position_scale(number<Real>(p.position_scale)),
        sigma(number<Real>(kernel.sigma)) {
    auto const all = PairScale<double>::of<D>(p.smoothing_length, kernel.sigma);
    scale = {number<Real>(all.h), number<Real>(all.inverse_h2), number<Real>(all.gradient_factor),
             number<Real>(all.softening2)};
  }

  /// Of a pair: the same for all, or where particles have smoothing lengths of their own, from
  /// these; at a wall that of the fluid particle, but no less than
  /// that of the case, which the lattice of wall particles is made for.
  template <bool wall, class Self, class Neighbour>
  MORAINE_FORMULA decltype(auto) scale_of(Self const& i, Neighbour const& j) const {
    if constexpr (!Self::has(PairField::smoothing_length))
      return (scale);  // a reference: GCC copies the vectors of a struct through memory
    else if constexpr (wall)
      return PairScale<Real>::template of<D>(maximum(smoothing_length(i), scale.h), sigma);
    else
      return PairScale<Real>::template of<D>(
          pair_smoothing(of_pair, smoothing_length(i), smoothing_length(j)), sigma);
  }

  Kernel kernel;
  PairSmoothing of_pair;
  Real position_scale;
  Real sigma;
  PairScale<Real> scale;  // of the case
};

/// Fills `lanes` with the neighbours of a list, W at a time, and calls use() for each lot. A
/// group of the list holds W neighbours or a multiple of W.
template <class Real, class Layout, class Use>
MORAINE_FORMULA void for_each_lanes(NeighbourGroups const& list, SlotOf<Real> const* records,
                                    Lanes<Real, Layout>& lanes, Use&& use) {
  constexpr std::size_t group = NeighbourList::lanes(Layout::dimension);
  static_assert(group % Real::size() == 0);
  std::uint16_t const* offsets = list.offsets;
  for (std::size_t g = 0; g < list.count; ++g) {
    auto const* const base = records + list.bases[g] * Layout::stride;
    for (std::size_t part = 0; part < group / Real::size(); ++part, offsets += Real::size()) {
      load_transposed<Layout::quads>(base, Layout::stride, offsets, lanes.packed);
      use();
    }
  }
}

/// Distance part of a pair; its approach and terms follow once walls have had their say.
template <class Real, int D, class Self, class Neighbour>
MORAINE_FORMULA Pair<Real, D> geometry(Real const& position_scale, Self const& self,
                                       Neighbour const& lanes) {
  Pair<Real, D> pair;
  pair.distance2 = number<Real>(0);
  for (int axis = 0; axis < D; ++axis) {
    pair.x[axis] = separation(self.position(axis), lanes.packed[axis], position_scale);
    pair.distance2 += pair.x[axis] * pair.x[axis];
  }
  return pair;
}

/// v_ij . x_ij and the gap as the wall's terms see them. Free slip: only the parts along the wall
/// normal n count, (v_ij . n)(x_ij . n); at no-slip walls and where the neighbour has no normal
/// (n = 0: corners) it is the whole product. A wall that turns has the normal velocity of the place
/// beside i there, v_j . n + x_ij . (n x w), so that fluid that turns with it does not meet it.
/// Forces keep the whole x_ij: the pressure in a wall varies along the wall.
template <class Real, int D, class Neighbour>
MORAINE_FORMULA void look_at_wall(Neighbour const& lanes, Real const (&v)[D], Pair<Real, D>& pair) {
  Real const zero = number<Real>(0);
  Real ahead = number<Real>(0);
  Real speed = number<Real>(0);
  Real length2 = number<Real>(0);
  for (int axis = 0; axis < D; ++axis) {
    ahead += pair.x[axis] * normal(lanes, axis);
    speed += v[axis] * normal(lanes, axis);
    if constexpr (Neighbour::has(PairField::wall_turn))
      speed -= pair.x[axis] * wall_turn(lanes, axis);
    length2 += normal(lanes, axis) * normal(lanes, axis);
  }
  Real const depth = wall_depth(lanes);
  Real const slipping = ahead * speed + (number<Real>(1) - length2) * pair.approach;
  pair.approach = select(zero < depth, slipping, pair.approach);
  // A wall particle speaks for its face only within 45 degrees of the normal: beside an edge the
  // plane of the other face means nothing. One without a normal, behind the edge, speaks for the
  // ball about it that reaches to the faces.
  Real const radius = maximum(depth, -depth);
  Real const outward = maximum(ahead, zero);
  Real const of_face = select(pair.distance2 < number<Real>(2) * outward * outward, ahead - radius,
                              number<Real>(1e6));
  pair.gap = select(length2 < number<Real>(0.5), square_root(pair.distance2) - radius, of_face);
}

/// Adds the neighbours in one list to `sum`. A wall has no internal energy: its pairs keep all of
/// their work, other pairs half of it.
///
/// Never inlined: two such loops in one function want more registers than there are, and what is
/// constant in a loop goes to memory (a third of the speed in 3D, and GCC does inline them when it
/// finds them small enough).
template <bool wall, class Real, int D, class Kernel, class Layout, class Self, class Terms>
[[gnu::noinline]] void sum_over_pairs(SweepConstants<Real, D, Kernel> const& constants,
                                      Self const& self, NeighbourGroups const& list,
                                      SlotOf<Real> const* records, Terms const& terms,
                                      PairSum<Real, D>& total) {
  PairSum<Real, D> sum = total;  // a local, which the compiler may keep in registers
  Real const energy_share = number<Real>(wall ? 1.0 : 0.5);
  Lanes<Real, Layout> lanes;
  lanes.uniform = self.uniform;
  for_each_lanes(
      list, records, lanes, [&]() __attribute__((always_inline)) {
        Pair<Real, D> pair = geometry<Real, D>(constants.position_scale, self, lanes);
        Real v[D];
        pair.approach = number<Real>(0);
        for (int axis = 0; axis < D; ++axis) {
          v[axis] = velocity(self, axis) - velocity(lanes, axis);
          pair.approach += v[axis] * pair.x[axis];
        }
        Real const along = pair.approach;  // what the force does work on
        if constexpr (wall) look_at_wall<Real, D>(lanes, v, pair);
        auto const& scale = constants.template scale_of<wall>(self, lanes);
        pair.h = scale.h;
        pair.mean_density = number<Real>(0.5) * (density(self) + density(lanes));
        pair.inverse = number<Real>(1) / ((pair.distance2 + scale.softening2) * pair.mean_density);
        Real const q = square_root(pair.distance2 * scale.inverse_h2);
        pair.gradient = scale.gradient_factor * constants.kernel.slope_over_q(q);

        PairRates<Real> rates{number<Real>(0), number<Real>(0), number<Real>(0)};
        std::apply([&](auto const&... term) { (term(pair, self, lanes, rates), ...); }, terms);

        Real const weight = pair_weight<wall>(lanes);
        Real const push = weight * rates.stress * pair.gradient;
        for (int axis = 0; axis < D; ++axis) sum.acceleration[axis] -= push * pair.x[axis];
        sum.energy_rate += energy_share * push * along;
        sum.density_rate += weight * rates.density_rate;
        sum.approach_speed = minimum(
            sum.approach_speed,
            select(q < number<Real>(kernel_support), rates.approach_speed, number<Real>(0)));
      });
  total = sum;
}

}  // namespace moraine
