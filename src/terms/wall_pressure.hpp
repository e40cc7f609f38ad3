#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Pressure between a fluid particle and a wall, which pushes and never pulls.
///
///   S_ij = max(0, p_i / rho_i^2 + p_j / rho_j^2)
///
/// p_j is the fluid's pressure continued into the wall (wall_extrapolation.hpp). Source: the
/// pressure force of Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543, eq. 3.3; the bound is
/// our own: water does not hang on a wall, and particles in free flight that carry a small tension
/// would stick to it.
struct WallPressure {
  template <class Real, int D, class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const&, Self const& i, Neighbour const& j,
                                  PairRates<Real>& rates) const {
    rates.stress += maximum(pressure_term(i) + pressure_term(j), number<Real>(0));
  }
};

}  // namespace moraine
