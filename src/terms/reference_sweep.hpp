// The pair loop written plainly: one neighbour at a time in scalar double.
//
// Nobody runs cases with it. It says in the fewest lines what the sweep must compute, and the tests
// hold every SIMD flavour against it.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "smoothing/any_kernel.hpp"
#include "smoothing/pair_smoothing.hpp"
#include "terms/sweep.hpp"

namespace moraine {

template <bool wall, int D, class Kernel, class Layout, class Self, class Terms>
void reference_sum(SweepParameters const& parameters, Self const& self,
                   std::span<std::uint32_t const> points, double const* records, Terms const& terms,
                   PairSum<double, D>& sum) {
  auto const kernel = make_kernel<Kernel>(parameters.kernel);
  for (std::uint32_t const j : points) {
    Broadcast<double, Layout> const neighbour{records + slot_of(j) * Layout::stride, self.uniform};
    Pair<double, D> pair{};
    for (int axis = 0; axis < D; ++axis) {
      pair.x[axis] = self.position(axis) - neighbour.position(axis);
      pair.distance2 += pair.x[axis] * pair.x[axis];
    }
    double h = parameters.smoothing_length;
    if constexpr (Self::has(PairField::smoothing_length)) {
      if constexpr (wall)
        h = std::max(h, smoothing_length(self));
      else
        h = pair_smoothing(parameters.of_pair, smoothing_length(self), smoothing_length(neighbour));
    }
    pair.h = h;
    double const q = std::sqrt(pair.distance2) / h;
    if (q >= kernel_support) continue;
    double v[D];
    double along = 0.0;  // what the force does work on
    for (int axis = 0; axis < D; ++axis) {
      v[axis] = velocity(self, axis) - velocity(neighbour, axis);
      along += v[axis] * pair.x[axis];
    }
    pair.approach = along;
    if constexpr (wall) {
      double ahead = 0.0;
      double speed = 0.0;
      double length2 = 0.0;
      for (int axis = 0; axis < D; ++axis) {
        ahead += pair.x[axis] * normal(neighbour, axis);
        speed += v[axis] * normal(neighbour, axis);
        if constexpr (std::decay_t<decltype(neighbour)>::has(PairField::wall_turn))
          speed -= pair.x[axis] * wall_turn(neighbour, axis);
        length2 += normal(neighbour, axis) * normal(neighbour, axis);
      }
      bool const has_face = length2 > 0.5;
      if (has_face && wall_depth(neighbour) > 0.0) pair.approach = ahead * speed;
      bool const in_front = ahead > 0.0 && pair.distance2 < 2.0 * ahead * ahead;
      double const radius = std::fabs(wall_depth(neighbour));
      pair.gap = in_front ? ahead - radius : 1e6;
      if (!has_face) pair.gap = std::sqrt(pair.distance2) - radius;
    }
    pair.mean_density = 0.5 * (density(self) + density(neighbour));
    pair.inverse = 1.0 / ((pair.distance2 + 0.01 * h * h) * pair.mean_density);
    pair.gradient = kernel.sigma / std::pow(h, D + 2) * kernel.slope_over_q(q);

    PairRates<double> rates{};
    std::apply([&](auto const&... term) { (term(pair, self, neighbour, rates), ...); }, terms);

    double const share = wall ? 1.0 : 0.5;
    double const weight = pair_weight<wall>(neighbour);
    for (int axis = 0; axis < D; ++axis)
      sum.acceleration[axis] -= weight * rates.stress * pair.gradient * pair.x[axis];
    sum.energy_rate += share * weight * rates.stress * pair.gradient * along;
    sum.density_rate += weight * rates.density_rate;
    sum.approach_speed = std::min(sum.approach_speed, rates.approach_speed);
  }
}

}  // namespace moraine
