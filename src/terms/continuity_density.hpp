#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Density by continuity, in one of two forms.
///
///   mass:    d rho_i / dt = sum_j m_j v_ij . grad_i W_ij
///   volume:  d rho_i / dt = rho_i sum_j (m_j / rho_j) v_ij . grad_i W_ij
///
/// Source: Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543, eq. 3.9 (mass); Monaghan, Rep.
/// Prog. Phys. 68 (2005) 1703, eq. 2.17 (volume). Both are exact for rigid motion. The mass form
/// wants neighbours of comparable density: beside a jump it is wrong by the ratio of the densities.
/// The volume form holds for any ratio; a liquid of one material does not need it. rho in kg/m^3.
template <class Real>
struct ContinuityDensity {
  Real volume_form;  // 1: volume, 0: mass

  template <int D, class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const& pair, Self const& i, Neighbour const& j,
                                  PairRates<Real>& rates) const {
    Real rate = pair.approach * pair.gradient;
    // In one liquid the forms differ by its slight compression only: no division there.
    if constexpr (Self::has(PairField::reference_density))
      rate += rate * volume_form * (density(i) / density(j) - number<Real>(1));
    rates.density_rate += rate;
  }
};

}  // namespace moraine
