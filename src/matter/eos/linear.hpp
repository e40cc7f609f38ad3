// Linear equation of state: a constant sound speed.
#pragma once

#include <cmath>
#include <limits>

#include "base/macros.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Linear (weakly compressible) liquid.
///
///   p = c_0^2 (rho - rho_0) + p_b,   p >= p_min,   c = c_0
///
/// Source: Morris, Fox and Zhu, J. Comput. Phys. 136 (1997) 214.
/// Symbols: rho_0 reference_density, c_0 reference_sound_speed, p_b background_pressure, p_min
/// least_pressure.
/// Range: rho > 0. Specific energy has no effect: dp/de = 0. Where the line would give less than
/// p_min the pressure is p_min; the sound speed is c_0 everywhere.
struct Linear {
  static constexpr char const* name = "linear";

  double reference_density = 1000.0;      // kg/m^3
  double reference_sound_speed = 1480.0;  // m/s
  double background_pressure = 0.0;       // Pa, at the reference density
  double reference_energy = 0.0;          // J/kg, no effect on the pressure
  double least_pressure = -std::numeric_limits<double>::infinity();  // Pa

  MORAINE_HD double pressure(double rho, double /*e*/) const {
    double const p =
        sound_speed_squared(rho, 0.0) * (rho - reference_density) + background_pressure;
    return p < least_pressure ? least_pressure : p;
  }

  MORAINE_HD double sound_speed_squared(double /*rho*/, double /*e*/) const {
    return reference_sound_speed * reference_sound_speed;
  }

  MORAINE_HD double sound_speed(double /*rho*/, double /*e*/) const {
    return reference_sound_speed;
  }

  MORAINE_HD StateResponse respond(double rho, double e) const {
    return {pressure(rho, e), reference_sound_speed};
  }

  /// Density at pressure `p` [Pa]: the largest at p = p_min; NaN for p < p_min, and where no
  /// positive density has it.
  MORAINE_HD double density_at_pressure(double p, double e) const {
    double const rho = reference_density + (p - background_pressure) / sound_speed_squared(p, e);
    return p >= least_pressure && rho > 0.0 ? rho : std::nan("");
  }

  /// The reference energy, because every energy gives the same pressure.
  MORAINE_HD double energy_at_pressure(double /*rho*/, double /*p*/) const {
    return reference_energy;
  }
};

}  // namespace moraine
