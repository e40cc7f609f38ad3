// Soils and rock: friction on the plane where it is overcome first.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/tensor.hpp"
#include "matter/strength/deviator.hpp"

namespace moraine {

/// Elastic, perfectly plastic after Mohr and Coulomb, without dilation:
///
///   (sigma_1 - sigma_3) + (sigma_1 + sigma_3) sin(phi) <= 2 c cos(phi)
///
/// Source: Chen & Han, Plasticity for Structural Engineers (1988), section 2.3. Plastic
/// strain runs along sigma_1 - sigma_3 and keeps the volume (angle of dilation zero), and so does
/// the return at the given pressure: sigma_1 and sigma_3 change by equal and opposite amounts
/// and sigma_2 stays, or, where that would change their order, it ends in the corner of the hexagon
/// there. It is the nearest point of the hexagon for phi = 0 alone.
/// Symbols: sigma_1 >= sigma_2 >= sigma_3 principal stresses (tension positive), phi
/// friction_angle [rad], c cohesion [Pa]. Below the pressure of the apex, -c / tan(phi), there is
/// no shear stress.
struct MohrCoulomb {
  static constexpr char const* name = "mohr_coulomb";

  double shear_modulus = 0.0;   // Pa, G
  double friction_angle = 0.0;  // rad, phi, in [0, pi/2[
  double cohesion = 0.0;        // Pa, c

  MORAINE_HD Deviator limit(Deviator const& s, double p) const {
    double const slope = std::sin(friction_angle);
    double const strength = 2.0 * (cohesion * std::cos(friction_angle) + p * slope);
    if (!(strength > 0.0)) return {};
    // The faces of the hexagon are nowhere nearer to its axis than this.
    if (2.0 * shear_norm(s) * std::sqrt(1.0 + slope * slope / 3.0) <= strength) return s;
    Principal state = principal(s);
    auto& [high, middle, low] = state.values;
    if (high - low + (high + low) * slope <= strength) return s;
    double const sum = high + low;
    double const difference = strength - sum * slope;
    double const face_high = 0.5 * (sum + difference);
    double const face_low = 0.5 * (sum - difference);
    if (face_high < middle) {  // two tensions alike
      high = middle = strength / (3.0 - slope);
      low = -2.0 * high;
    } else if (face_low > middle) {  // two compressions alike
      low = middle = -strength / (3.0 + slope);
      high = -2.0 * low;
    } else {
      high = face_high;
      low = face_low;
    }
    return from_principal(state);
  }
};

}  // namespace moraine
