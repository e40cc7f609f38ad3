#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"
#include "terms/pressure_force.hpp"

namespace moraine {

/// Pressure between a fluid particle and a wall, which pushes and never pulls.
///
///   conservative:  S_ij = max(0, p_i / rho_i^2 + p_j / rho_j^2)
///   mixed:         S_ij = max(0, (p_i + p_j) / (rho_i rho_j))
///
/// p_j and rho_j are the fluid's, continued into the wall (wall_extrapolation.hpp). Source: the
/// pressure force of Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543, eq. 3.3, and its mixed
/// form (pressure_force.hpp), in which the mass of a wall particle drops out: a wall that two
/// fluids touch has their mean density, which weighs on neither. The bound is our own: water does
/// not hang on a wall, and particles in free flight that carry a small tension would stick to it.
struct WallPressure {
  PressureForce form;

  template <class Real, int D, class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const& pair, Self const& i, Neighbour const& j,
                                  PairRates<Real>& rates) const {
    PairRates<Real> both{number<Real>(0), number<Real>(0), number<Real>(0)};
    form(pair, i, j, both);
    rates.stress += maximum(both.stress, number<Real>(0));
  }
};

}  // namespace moraine
