#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Density diffusion between particles of one material, which damps pressure noise.
///
///   d rho_i / dt += sum_j (m_j / rho_ij) 2 delta h c_ij (rho_i - rho_j - rho_H) x_ij . grad_i W_ij
///                   / (r_ij^2 + phi^2)
///   rho_H = rho_0 g . x_ij / c_0^2: the difference that belongs to hydrostatic equilibrium
///
/// Source: Molteni & Colagrossi, Comput. Phys. Commun. 180 (2009) 861, eq. 8, with the hydrostatic
/// part taken out as in Fourtakas et al., Comput. Fluids 190 (2019) 346, eq. 9 (here linearised:
/// exact to the order of p / (rho_0 c_0^2)). delta = 0.1 is usual; 0 switches it off. phi = 0.1 h.
/// The volume uses the mean density rho_ij where the source has rho_j: the exchange between equal
/// masses is then exactly antisymmetric.
template <class Real, int D>
struct DensityDiffusion {
  Real strength;              // 2 delta [-]
  Real hydrostatic_slope[D];  // g / c_0^2 [1/m]

  template <class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const& pair, Self const& i, Neighbour const& j,
                                  PairRates<Real>& rates) const {
    Real hydrostatic = number<Real>(0);  // difference of compression at equilibrium, i minus j
    for (int axis = 0; axis < D; ++axis) hydrostatic += hydrostatic_slope[axis] * pair.x[axis];
    Real const c = number<Real>(0.5) * (sound_speed(i) + sound_speed(j));
    Real const difference = compression(i) - compression(j) - hydrostatic;
    Real const flux = strength * pair.h * c * reference_density(i) * difference * pair.distance2 *
                      pair.gradient * pair.inverse;
    rates.density_rate +=
        select(reference_density(i) == reference_density(j), flux, number<Real>(0));
  }
};

}  // namespace moraine
