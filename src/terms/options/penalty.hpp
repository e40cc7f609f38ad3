#pragma once

#include "terms/options/option_pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Keeps particles of different groups from passing between each other.
///
///   f_i = P (p^n1 - p^n2) x_ij / r^2,   p = lambda (h_i + h_j) / (2 r),   for p > 1, else 0
///   U_ij = P ((p^n1 - 1) / n1 - (p^n2 - 1) / n2)
///   k_ij = - d|f| / dr = P ((n1 + 1) p^n1 - (n2 + 1) p^n2) / r^2
///
/// Source: Liu & Liu, Smoothed Particle Hydrodynamics (2003), chapter 6 (n1 6, n2 4 in codes
/// that descend from it; 12 and 6 here by default). P in N (per metre of thickness) in 2D, J in 3D.
/// Departure: the source has lambda = 1, which repels at rest wherever h is more than a spacing;
/// with lambda = spacing / h particles at rest on a lattice feel nothing. f is the slope of U at
/// constant h, so that kinetic + internal energy + U is then conserved. Where h varies, the reach
/// varies with it, and U changes besides by
///   P (p^n1 - p^n2) (h_i' + h_j') / (h_i + h_j)
/// per pair and time, which nobody books. Exponents are whole numbers.
template <class Real>
struct Penalty {
  Real strength;   // P
  Real range;      // lambda / 2 [-]
  int repulsion;   // n1
  int attraction;  // n2
  bool on;

  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           OptionSum<Real, D>& sum) const {
    if constexpr (!wall) {
      if (!on) return;
      Real const one = number<Real>(1);
      Real const tiny = number<Real>(1e-30);
      Real const inverse2 = one / maximum(pair.distance2, tiny);
      Real const reach = range * (smoothing_length(i) + smoothing_length(j));
      Real const p = maximum(reach * square_root(inverse2), one);
      Real const high = power(p, repulsion);
      Real const low = power(p, attraction);
      // Of one group, or in reach of nobody: nothing.
      Real const share = select(group(i) == group(j), number<Real>(0), strength);
      Real const push = share * (high - low) * inverse2;
      for (int axis = 0; axis < D; ++axis) sum.penalty_force[axis] += push * pair.x[axis];
      Real const n1 = number<Real>(repulsion);
      Real const n2 = number<Real>(attraction);
      // Also of pairs that are about to touch: the step must be short before they push.
      Real const stiffness = share * ((n1 + one) * high - (n2 + one) * low) * inverse2;
      Real const near = number<Real>(1.25) * reach;
      sum.stiffness += select(pair.distance2 < near * near, stiffness, number<Real>(0));
      sum.potential += number<Real>(0.5) * share * ((high - one) / n1 - (low - one) / n2);
    }
  }

 private:
  MORAINE_FORMULA static Real power(Real const& p, int exponent) {
    Real result = number<Real>(1);
    for (int k = 0; k < exponent; ++k) result = result * p;
    return result;
  }
};

}  // namespace moraine
