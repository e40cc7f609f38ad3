#pragma once

#include "terms/options/option_pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// The part of delta-SPH's density diffusion that takes the smooth gradient of density out.
///
///   d rho_i / dt += - delta sum_j h c_ij (m_j / rho_ij) (grad rho_i + grad rho_j) . grad_i W_ij
///
/// Source: Antuono, Colagrossi, Marrone & Molteni, Comput. Phys. Commun. 181 (2010) 532:
/// together with terms/density_diffusion.hpp (whose hydrostatic part is then zero) it makes
/// psi_ij = 2 (rho_i - rho_j) x_ij / r^2 - (grad rho_i + grad rho_j). grad rho: corrected gradient
/// of terms/options/moments.hpp, over the neighbours of the same reference density. Departure:
/// rho_ij stands where the source has rho_j, c_ij and h of the pair where it has c_0 and h: the
/// exchange between equal masses is antisymmetric.
template <class Real>
struct GradientDiffusion {
  Real delta;  // [-]
  bool on;

  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           OptionSum<Real, D>& sum) const {
    if constexpr (!wall && Self::has(PairField::density_gradient)) {
      if (!on) return;
      Real along = number<Real>(0);
      for (int axis = 0; axis < D; ++axis)
        along += (density_gradient(i, axis) + density_gradient(j, axis)) * pair.x[axis];
      Real const c = number<Real>(0.5) * (sound_speed(i) + sound_speed(j));
      Real const flux = number<Real>(-2) * delta * c * pair.h * mass(j) * along * pair.gradient /
                        (density(i) + density(j));
      sum.diffusion += select(reference_density(i) == reference_density(j), flux, number<Real>(0));
    }
  }
};

}  // namespace moraine
