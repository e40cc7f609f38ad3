#pragma once

#include "terms/options/option_pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// XSPH: particles move with a velocity averaged over their neighbours.
///
///   dx_i/dt = v_i + epsilon sum_j (m_j / rho_ij) (v_j - v_i) W_ij
///
/// Source: Monaghan, J. Comput. Phys. 82 (1989) 1. epsilon 0 to 1, 0.5 is usual. v and the
/// equations of motion stay what they are. sum m_i (dx_i/dt - v_i) = 0, since rho_ij is symmetric.
/// Walls of dummies take no part; images at mirrors are fluid and do.
template <class Real>
struct VelocityAveraging {
  Real epsilon;  // [-]
  bool on;

  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           OptionSum<Real, D>& sum) const {
    if constexpr (!wall) {
      if (!on) return;
      Real const weight =
          number<Real>(2) * epsilon * mass(j) * pair.kernel / (density(i) + density(j));
      for (int axis = 0; axis < D; ++axis) sum.drift[axis] -= weight * pair.v[axis];
    }
  }
};

}  // namespace moraine
