#pragma once

#include "base/macros.hpp"

namespace moraine {

/// What one particle of a repulsive wall does to a particle of the fluid, per unit mass.
struct Repulsion {
  double over_distance = 0.0;  // acceleration / x [1/s^2]
  double potential = 0.0;      // J/kg
  double stiffness = 0.0;      // -d(acceleration)/dr [1/s^2]
};

/// Stiffness at the range, from inside: 8 D / r_0^2 [1/s^2].
MORAINE_FORMULA double stiffness_at_range(double strength, double range) {
  return 8.0 * strength / (range * range);
}

/// Repulsion of a wall particle.
///
///   a = D ((r_0/r)^12 - (r_0/r)^4) x / r^2,   r < r_0
///   U = D ((r_0/r)^12 / 12 - (r_0/r)^4 / 4 + 1/6),   a = - grad U
///
/// Source: Monaghan, J. Comput. Phys. 110 (1994) 399, section 4, with the exponents 12 and 4;
/// Liu & Liu, Smoothed Particle Hydrodynamics (2003), chapter 4. x from the wall particle to the
/// fluid particle in m, r = |x|, D `strength` in m^2/s^2, r_0 `range` in m. Zero from r_0 on, where
/// force and potential vanish and the stiffness drops from 8 D / r_0^2. r = 0 gives what is no
/// number. The potential is our own integral, with U(r_0) = 0.
MORAINE_FORMULA Repulsion repulsion(double strength, double range, double distance2) {
  double const q = range * range / distance2;
  if (!(q > 1.0)) return {};
  double const q2 = q * q;
  double const q6 = q2 * q2 * q2;
  double const scale = strength / distance2;
  return {scale * (q6 - q2), strength * (q6 / 12.0 - q2 / 4.0 + 1.0 / 6.0),
          scale * (13.0 * q6 - 5.0 * q2)};
}

}  // namespace moraine
