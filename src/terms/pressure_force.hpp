#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Pressure gradient in the conservative form.
///
///   S_ij = p_i / rho_i^2 + p_j / rho_j^2
///
/// Source: Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543, eqs 3.3 and 4.4 (energy). p in
/// Pa, positive in compression; symmetric in i and j, so momentum and energy are conserved.
struct PressureForce {
  template <class Real, int D, class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const&, Self const& i, Neighbour const& j,
                                  PairRates<Real>& rates) const {
    rates.stress += pressure_term(i) + pressure_term(j);
  }
};

}  // namespace moraine
