#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Pressure gradient, in one of two forms.
///
///   conservative:  S_ij = p_i / rho_i^2 + p_j / rho_j^2
///   mixed:         S_ij = (p_i + p_j) / (rho_i rho_j)
///
/// Source: Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543, eqs 3.3 and 4.4 (energy); Liu &
/// Liu, Smoothed Particle Hydrodynamics (2003), section 4.3. p in Pa, positive in
/// compression; both are symmetric in i and j, so momentum and energy are conserved. The forms are
/// the adjoints of the mass and the volume form of the continuity equation: the mixed one holds at
/// any jump of density, where the conservative one weighs the pressure of the lighter side too
/// much.
struct PressureForce {
  bool mixed;  // the same for all pairs: a jump that is always guessed right

  template <class Real, int D, class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const&, Self const& i, Neighbour const& j,
                                  PairRates<Real>& rates) const {
    // In one liquid the forms differ by its slight compression only: no division there.
    if constexpr (Self::has(PairField::reference_density)) {
      if (mixed) {
        Real const rho_i = density(i);
        Real const rho_j = density(j);
        rates.stress +=
            (pressure_term(i) * rho_i * rho_i + pressure_term(j) * rho_j * rho_j) / (rho_i * rho_j);
        return;
      }
    }
    rates.stress += pressure_term(i) + pressure_term(j);
  }
};

}  // namespace moraine
