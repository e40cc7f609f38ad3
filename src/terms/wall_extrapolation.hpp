// The state of the fluid continued into a wall.
#pragma once

#include <cstdint>
#include <span>

#include "terms/reference_sweep.hpp"
#include "terms/sweep.hpp"

namespace moraine {

/// What a wall particle takes from the fluid around it.
struct WallState {
  double weight = 0.0;       // sum of W [1/m^d]; zero where no fluid is near
  double pressure = 0.0;     // Pa
  double density = 0.0;      // kg/m^3
  double sound_speed = 0.0;  // m/s
};

template <class Real>
struct WallSums {
  Real weight, pressure, density, sound_speed, head;
};

template <class Real, int D, class Neighbour>
MORAINE_FORMULA void add_to_wall(Real const& w, Real const (&x)[D], Real const (&gravity)[D],
                                 Neighbour const& j, WallSums<Real>& sums) {
  Real const rho = density(j);
  Real along_gravity = number<Real>(0);
  for (int axis = 0; axis < D; ++axis) along_gravity += gravity[axis] * x[axis];
  sums.weight += w;
  sums.pressure += w * pressure_term(j) * rho * rho;
  sums.density += w * rho;
  sums.sound_speed += w * sound_speed(j);
  sums.head += w * rho * along_gravity;
}

/// Pressure, density and sound speed at a wall particle.
///
///   p_w = (sum_f p_f W_wf + (g - a_w) . sum_f rho_f x_wf W_wf) / sum_f W_wf
///
/// Source: Adami, Hu & Adams, J. Comput. Phys. 231 (2012) 7057, eq. 27; density and sound speed are
/// the plain kernel means. a_w: acceleration of the wall there; `seen_gravity` is g - a_w in m/s^2.
/// x_wf = x_w - x_f in m.
template <bool reference, class Real, int D, class Kernel, class Layout>
WallState extrapolate(SweepParameters const& parameters, SlotOf<Real> const* self_record,
                      SlotOf<Real> const* uniform, NeighbourList const& lists, std::size_t i,
                      SlotOf<Real> const* records, std::array<double, 3> const& seen_gravity) {
  using Number = std::conditional_t<reference, double, Real>;
  auto const kernel = make_kernel<Kernel>(parameters.kernel);
  WallSums<Number> sums{};
  Number gravity[D];
  for (int axis = 0; axis < D; ++axis)
    gravity[axis] = number<Number>(seen_gravity[static_cast<std::size_t>(axis)]);
  Number const inverse_h = number<Number>(1.0 / parameters.smoothing_length);
  // Weights of a mean must not be negative, as some kernels are far outside.
  auto const positive = [](Number const& w) __attribute__((always_inline)) {
    return maximum(w, number<Number>(0));
  };
  auto const add = [&](auto const& neighbour, Number const(&x)[D]) {
    Number distance2 = number<Number>(0);
    for (int axis = 0; axis < D; ++axis) distance2 += x[axis] * x[axis];
    using Neighbour = std::decay_t<decltype(neighbour)>;
    if constexpr (Neighbour::has(PairField::smoothing_length)) {
      Number const own = number<Number>(1) / maximum(smoothing_length(neighbour),
                                                     number<Number>(parameters.smoothing_length));
      Number const volume = D == 1 ? own : (D == 2 ? own * own : own * own * own);
      add_to_wall<Number, D>(volume * positive(kernel.shape(square_root(distance2) * own)), x,
                             gravity, neighbour, sums);
    } else {
      add_to_wall<Number, D>(positive(kernel.shape(square_root(distance2) * inverse_h)), x, gravity,
                             neighbour, sums);
    }
  };
  Number x[D];
  if constexpr (reference) {
    for (std::uint32_t const j : lists.points(i)) {
      Broadcast<double, Layout> const neighbour{records + slot_of(j) * Layout::stride, uniform};
      for (int axis = 0; axis < D; ++axis) x[axis] = self_record[axis] - neighbour.position(axis);
      add(neighbour, x);
    }
  } else {
    Real const scale = number<Real>(parameters.position_scale);
    Lanes<Real, Layout> lanes;
    lanes.uniform = uniform;
    for_each_lanes(
        lists.of(i), records, lanes, [&]() __attribute__((always_inline)) {
          for (int axis = 0; axis < D; ++axis)
            x[axis] = separation(self_record[axis], lanes.packed[axis], scale);
          add(lanes, x);
        });
  }
  // What is common to all weights, the normalisation of the kernel, drops out of all ratios.
  double const weight = sum_of_lanes(sums.weight);
  if (!(weight > 0.0)) return {};
  return {weight, (sum_of_lanes(sums.pressure) + sum_of_lanes(sums.head)) / weight,
          sum_of_lanes(sums.density) / weight, sum_of_lanes(sums.sound_speed) / weight};
}

}  // namespace moraine
