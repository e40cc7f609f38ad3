// Artificial stress of a particle.
#pragma once

#include "base/tensor.hpp"
#include "matter/strength/deviator.hpp"

namespace moraine {

/// R with the principal directions of sigma = s - p 1 and the principal values
///
///   R_k = -epsilon sigma_k / rho^2   where sigma_k > 0 (tension), else 0
///
/// Source: Gray, Monaghan & Swift (2001), eq. 33. Symbols: p pressure [Pa], rho density [kg/m^3],
/// epsilon share [-], 0.3 in the source.
MORAINE_HD inline Symmetric<3> artificial_stress_of(Deviator const& s, double p, double rho,
                                                    double epsilon) {
  // No principal value of s is larger than 2 sqrt(J2 / 3).
  if (p >= 1.1547005383792517 * shear_norm(s)) return {};
  Principal state = principal({s[0] - p, s[1] - p, s[2] - p, s[3], s[4], s[5]});
  for (double& value : state.values) value = value > 0.0 ? -epsilon * value / (rho * rho) : 0.0;
  return from_principal(state);
}

}  // namespace moraine
