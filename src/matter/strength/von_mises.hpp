// Metals, and undrained clay: a strength that does not depend on the pressure.
#pragma once

#include "matter/strength/radial_return.hpp"

namespace moraine {

/// Elastic, perfectly plastic after von Mises:
///
///   sqrt(J2) <= Y / sqrt(3)
///
/// Source: Hill, The Mathematical Theory of Plasticity (1950), chapter 2. Y: yield_strength in
/// uniaxial tension [Pa]; in pure shear it yields at Y / sqrt(3), of clay that is the undrained
/// strength c_u.
struct VonMises {
  static constexpr char const* name = "von_mises";

  double shear_modulus = 0.0;   // Pa, G
  double yield_strength = 0.0;  // Pa, Y

  MORAINE_HD Deviator limit(Deviator const& s, double) const {
    return radial_return(s, yield_strength * 0.57735026918962576);
  }
};

}  // namespace moraine
