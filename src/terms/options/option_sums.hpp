// Sums of kernel values: density by summation, and the velocity of the fluid before a wall.
#pragma once

#include "terms/options/option_pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

template <class Real>
struct DensitySum {
  Real density;  // sum_j m_j W_ij [kg/m^3]
  Real volume;   // sum_j m_j / rho_j W_ij [-]
};

/// Density by summation, without the particle itself.
///
///   rho_i = sum_j m_j W_ij,   normalised: divided by sum_j (m_j / rho_j) W_ij
///
/// Source: Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543; Chen, Beraun & Carney,
/// Int. J. Numer. Meth. Eng. 46 (1999) 231 (normalised: rho_j there are plain sums).
struct SummedDensity {
  template <bool wall, class Real, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const&, Neighbour const& j,
                           DensitySum<Real>& sum) const {
    Real const weight = pair_weight<wall>(j) * pair.kernel;
    sum.density += weight;
    if constexpr (wall)
      sum.volume += lattice_volume(j) * pair.kernel;
    else
      sum.volume += weight / density(j);
  }
};

template <class Real, int D>
struct VelocitySum {
  Real weight;       // sum_f W_wf [1/m^d]
  Real velocity[D];  // sum_f v_f W_wf
};

/// Velocity of the fluid at a wall particle, for the velocity that a wall without slip shows:
/// 2 v_w - sum_f v_f W_wf / sum_f W_wf. Source: Adami, Hu & Adams, J. Comput. Phys. 231 (2012)
/// 7057, eqs 22 and 23.
struct VelocityBeforeWall {
  template <bool wall, class Real, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const&, Neighbour const& j,
                           VelocitySum<Real, D>& sum) const {
    Real const w = maximum(pair.kernel, number<Real>(0));
    sum.weight += w;
    for (int axis = 0; axis < D; ++axis) sum.velocity[axis] += w * velocity(j, axis);
  }
};

}  // namespace moraine
