// Soils and rock: a strength that grows with the pressure.
#pragma once

#include <algorithm>

#include "matter/strength/radial_return.hpp"

namespace moraine {

/// Elastic, perfectly plastic after Drucker and Prager, without dilation:
///
///   sqrt(J2) <= Y = max(0, k + 3 alpha p)
///
/// Source: Drucker & Prager, Q. Appl. Math. 10 (1952) 157, with I1 = -3 p; plastic strain keeps the
/// volume (Wilkins' radial return), so that it is not associated.
/// Symbols: alpha yield_slope, k shear_strength [Pa]. A soil of friction angle phi and cohesion c
/// has, on the cone through the compression corners of Mohr and Coulomb,
///   alpha = 2 sin(phi) / (sqrt(3) (3 - sin(phi))),  k = 6 c cos(phi) / (sqrt(3) (3 - sin(phi))).
/// Below the pressure of the apex, -k / (3 alpha), there is no shear stress at all; the floor of
/// the equation of state, least_pressure, must not be lower, or the material bears a tension
/// beyond its cone.
struct DruckerPrager {
  static constexpr char const* name = "drucker_prager";

  double shear_modulus = 0.0;   // Pa, G
  double yield_slope = 0.0;     // -, alpha
  double shear_strength = 0.0;  // Pa, k, at zero pressure

  MORAINE_HD double strength_at(double p) const {
    return std::max(0.0, shear_strength + 3.0 * yield_slope * p);
  }

  MORAINE_HD Deviator limit(Deviator const& s, double p) const {
    return radial_return(s, strength_at(p));
  }
};

}  // namespace moraine
