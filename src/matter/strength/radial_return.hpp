// Return to a yield surface that is round in the deviatoric plane.
#pragma once

#include <algorithm>

#include "matter/strength/deviator.hpp"

namespace moraine {

/// The nearest stress with sqrt(J2) <= `shear_strength` [Pa, not negative]:
///
///   s min(1, Y / sqrt(J2))
///
/// Source: Wilkins, in Methods in Computational Physics 3 (1964) 211. Exact for a deviatoric
/// strain along s; the direction of s does not change.
MORAINE_HD inline Deviator radial_return(Deviator const& s, double shear_strength) {
  double const norm = shear_norm(s);
  return norm > shear_strength ? scaled(s, shear_strength / norm) : s;
}

}  // namespace moraine
