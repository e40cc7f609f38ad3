#pragma once

#include "terms/options/option_pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// What the correction of the kernel gradient changes in continuity and pressure, K = L - 1.
///
///   mass:          d rho_i/dt += sum_j m_j v_ij . K_i grad_i W_ij
///   volume:        the same, times rho_i / rho_j
///   conservative:  dv_i/dt -= sum_j m_j (p_i / rho_i^2 K_i + p_j / rho_j^2 K_j) grad_i W_ij
///   mixed:         the same with p_i / (rho_i rho_j), p_j / (rho_i rho_j)
///   energy:        de_i/dt += share sum_j m_j v_ij . (...) grad_i W_ij, share 1/2, at walls 1
///
/// Source: Bonet & Lok, Comput. Methods Appl. Mech. Eng. 180 (1999) 97. Together
/// with the terms of the main sweep, whose gradient is plain, it makes L_i grad W and its adjoint.
/// L_i grad W is exact for linear velocities. Momentum and energy are conserved; the force is not
/// along x_ij. A wall has K_j = 0, and with free slip only the velocity along its normal counts.
template <class Real>
struct CorrectedGradient {
  bool on;
  bool mixed;
  bool volume;

  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           OptionSum<Real, D>& sum) const {
    if constexpr (Self::has(PairField::correction)) {
      if (!on) return;
      Real const weight = pair_weight<wall>(j) * pair.gradient;
      Real const rho_ratio = density(i) / density(j);
      Real p_i = pressure_term(i);
      Real p_j = pressure_term(j);
      if (mixed) {
        p_i = p_i * rho_ratio;
        p_j = p_j / rho_ratio;
      }
      if constexpr (wall) {
        // As the pressure of a wall, which never pulls.
        p_i = maximum(p_i + p_j, number<Real>(0));
        p_j = number<Real>(0);
      }
      auto const own = [&i](int k) __attribute__((always_inline)) { return correction(i, k); };
      Real rate = number<Real>(0);
      Real work = number<Real>(0);
      Real slipping[D];
      if constexpr (wall)
        slipping_velocity<D>(i, j, slipping);
      else
        for (int axis = 0; axis < D; ++axis) slipping[axis] = pair.v[axis];
      for (int axis = 0; axis < D; ++axis) {
        Real const turned = row_times<D>(own, pair.x, axis);
        Real push = p_i * turned;
        if constexpr (!wall) {
          auto const other = [&j](int k) __attribute__((always_inline)) {
            return correction(j, k);
          };
          push += p_j * row_times<D>(other, pair.x, axis);
        }
        sum.acceleration[axis] -= weight * push;
        Real v = pair.v[axis];
        if constexpr (wall) v = velocity(i, axis) - wall_velocity(j, axis);
        work += push * v;
        rate += slipping[axis] * turned;
      }
      sum.density_rate += weight * rate * (volume ? rho_ratio : number<Real>(1));
      sum.energy_rate += number<Real>(wall ? 1.0 : 0.5) * weight * work;
    }
  }
};

}  // namespace moraine
