#pragma once

#include "terms/options/option_pair.hpp"
#include "terms/options/option_parameters.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Viscosity of a Newtonian fluid, in one of two forms, F = x_ij . grad_i W_ij / r^2 <= 0.
///
///   morris:           dv_i/dt += sum_j m_j (mu_i + mu_j) / (rho_i rho_j) F v_ij
///   monaghan_cleary:  dv_i/dt += sum_j m_j 2 (d + 2) / (rho_i rho_j) 2 mu_i mu_j / (mu_i + mu_j)
///                                v_ij . x_ij / r^2 grad_i W_ij
///   both:             de_i/dt -= share sum_j f_ij . v_ij, share 1/2; 1 at walls, v_j that of the
///                                wall
///
/// Source: Morris, Fox & Zhu, J. Comput. Phys. 136 (1997) 214, eq. 22 (morris); Cleary, Appl. Math.
/// Model. 22 (1998) 981, with the factor 2 (d + 2) of Monaghan, Rep. Prog. Phys. 68 (2005)
/// 1703 (Cleary's 4.963 is fitted to lattices), and the harmonic mean of mu.
/// mu: dynamic viscosity in Pa s. The first acts along v_ij, so it does not conserve angular
/// momentum; the second acts along x_ij and does. Both conserve momentum and energy. A wall shows
/// the viscosity of the particle that looks at it.
/// Departure: the sources have r^2 + 0.01 h^2 below; nothing here is singular without it, and it
/// takes 1.5 to 2 % of the viscosity away at any spacing.
template <class Real>
struct PhysicalViscosity {
  ViscosityForm form;

  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           OptionSum<Real, D>& sum) const {
    if (form == ViscosityForm::off) return;
    Real const mu_i = dynamic_viscosity(i);
    Real mu_j = mu_i;
    if constexpr (!wall) mu_j = dynamic_viscosity(j);
    Real const weight = pair_weight<wall>(j) * pair.gradient / (density(i) * density(j));
    Real slip = number<Real>(1);  // a wall with free slip does not drag
    if constexpr (wall) slip = select(wall_depth(j) < number<Real>(0), slip, number<Real>(0));
    Real force[D];
    if (form == ViscosityForm::morris) {
      Real const factor = slip * weight * (mu_i + mu_j);
      for (int axis = 0; axis < D; ++axis) force[axis] = factor * pair.v[axis];
    } else {
      Real const mean = mu_i * mu_j / maximum(mu_i + mu_j, number<Real>(1e-30));
      Real approach = number<Real>(0);
      for (int axis = 0; axis < D; ++axis) approach += pair.v[axis] * pair.x[axis];
      Real const along = approach / maximum(pair.distance2, number<Real>(1e-30));
      Real const factor = slip * weight * number<Real>(4 * (D + 2)) * mean * along;
      for (int axis = 0; axis < D; ++axis) force[axis] = factor * pair.x[axis];
    }
    Real work = number<Real>(0);
    for (int axis = 0; axis < D; ++axis) {
      sum.acceleration[axis] += force[axis];
      if constexpr (wall)
        work += force[axis] * (velocity(i, axis) - wall_velocity(j, axis));
      else
        work += force[axis] * pair.v[axis];
    }
    Real const heat = number<Real>(wall ? -1.0 : -0.5) * work;
    sum.energy_rate += heat;
    sum.viscous_heat += heat;
  }
};

}  // namespace moraine
