#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Density by continuity.
///
///   d rho_i / dt = sum_j m_j v_ij . grad_i W_ij
///
/// Source: Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543, eq. 3.9. Exact for rigid motion;
/// rho is kg/m^3. Valid for any density ratio of neighbours of comparable particle volume.
struct ContinuityDensity {
  template <class Real, int D, class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const& pair, Self const&, Neighbour const&,
                             PairRates<Real>& rates) const {
    rates.density_rate += pair.approach * pair.gradient;
  }
};

}  // namespace moraine
