// Tait equation of state: a liquid whose pressure depends on density alone.
#pragma once

#include <cmath>

#include "base/macros.hpp"
#include "base/power.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Tait (Murnaghan) liquid.
///
///   p = B ((rho/rho_0)^gamma - 1) + p_b,   B = rho_0 c_0^2 / gamma
///
///   c = c_0 (rho/rho_0)^((gamma-1)/2)
///
/// Source: Cole, Underwater Explosions (1948), chapter 2; in SPH: Monaghan, J. Comput. Phys. 110
/// (1994) 399.
/// Symbols: rho_0 reference_density, c_0 reference_sound_speed, gamma exponent, p_b
/// background_pressure.
/// Range: rho > 0. Specific energy has no effect: dp/de = 0. Tension is not limited: as rho goes
/// to 0, p goes to p_b - B.
struct Tait {
  static constexpr char const* name = "tait";

  double reference_density = 1000.0;      // kg/m^3
  double reference_sound_speed = 1480.0;  // m/s, at the reference density
  double exponent = 7.0;                  // -, at least 1
  double background_pressure = 0.0;       // Pa, at the reference density
  double reference_energy = 0.0;          // J/kg, no effect on the pressure

  /// B = rho_0 c_0^2 / gamma [Pa].
  MORAINE_HD double stiffness() const {
    return reference_density * reference_sound_speed * reference_sound_speed / exponent;
  }

  MORAINE_HD double pressure(double rho, double /*e*/) const {
    return stiffness() * (power(rho / reference_density, exponent) - 1.0) + background_pressure;
  }

  MORAINE_HD double sound_speed_squared(double rho, double /*e*/) const {
    return reference_sound_speed * reference_sound_speed *
           power(rho / reference_density, exponent - 1.0);
  }

  MORAINE_HD double sound_speed(double rho, double e) const {
    return signed_root(sound_speed_squared(rho, e));
  }

  MORAINE_HD StateResponse respond(double rho, double e) const {
    double const c2 = sound_speed_squared(rho, e);
    // One power serves both: B (rho/rho_0)^gamma = rho c^2 / gamma.
    return {rho * c2 / exponent - stiffness() + background_pressure, signed_root(c2)};
  }

  /// Density at pressure `p` [Pa]; NaN for p <= p_b - B, which no density reaches.
  MORAINE_HD double density_at_pressure(double p, double /*e*/) const {
    double const ratio = 1.0 + (p - background_pressure) / stiffness();
    return ratio > 0.0 ? reference_density * std::pow(ratio, 1.0 / exponent) : std::nan("");
  }

  /// The reference energy, because every energy gives the same pressure.
  MORAINE_HD double energy_at_pressure(double /*rho*/, double /*p*/) const {
    return reference_energy;
  }
};

}  // namespace moraine
