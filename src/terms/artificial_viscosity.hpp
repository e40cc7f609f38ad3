#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Monaghan's artificial viscosity, acting on pairs that come closer.
///
///   Pi_ij = (-alpha c_ij mu_ij + beta mu_ij^2) / rho_ij  for v_ij . x_ij < 0, else 0
///   mu_ij = h v_ij . x_ij / (r_ij^2 + phi^2),  phi = 0.1 h;  c_ij, rho_ij: means of the two
///
/// Source: Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543, eqs 4.1-4.2, with phi as in Liu &
/// Liu, Smoothed Particle Hydrodynamics (2003). alpha = 1, beta = 10 for blast, alpha about 0.1,
/// beta = 0 for free-surface water. Symmetric in i and j; always takes kinetic energy.
template <class Real>
struct ArtificialViscosity {
  Real alpha;  // [-]
  Real beta;   // [-]

  template <int D, class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const& pair, Self const& i, Neighbour const& j,
                                  PairRates<Real>& rates) const {
    Real const c = number<Real>(0.5) * (sound_speed(i) + sound_speed(j));
    Real const mu_by_rho = pair.h * minimum(pair.approach, number<Real>(0)) * pair.inverse;
    Real const mu = mu_by_rho * pair.mean_density;
    rates.stress += mu_by_rho * (beta * mu - alpha * c);
    rates.approach_speed = minimum(rates.approach_speed, mu);
  }
};

}  // namespace moraine
