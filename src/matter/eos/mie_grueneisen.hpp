// Mie-Grueneisen equation of state with the shock curve as a cubic polynomial: solids and soils.
#pragma once

#include <cmath>
#include <limits>

#include "base/bisect.hpp"
#include "base/macros.hpp"
#include "matter/eos/pressure_floor.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Mie-Grueneisen, polynomial in the compression mu = rho / rho_0 - 1.
///
///   p = (1 - Gamma mu / 2) p_H + Gamma rho e
///
///   mu >= 0:  p_H = a0 mu + b0 mu^2 + c0 mu^3
///   mu < 0:   p_H = a0 mu
///   a0 = rho_0 C^2,  b0 = a0 (1 + 2 (S - 1)),  c0 = a0 (2 (S - 1) + 3 (S - 1)^2)
///   p >= p_min
///
/// Source: Liu and Liu, Smoothed Particle Hydrodynamics (2003), chapter 8; Libersky et al., J.
/// Comput. Phys. 109 (1993) 67. p_H is the Hugoniot curve from the undisturbed state with e = 0,
/// and the first three terms of that of a straight line U_s = C + S u_p (matter/eos/us_up.hpp).
/// Symbols: C reference_sound_speed, S hugoniot_slope, Gamma grueneisen_coefficient, p_min
/// least_pressure. Gamma is constant, so that Gamma rho grows with the density.
/// Range: rho > 0. c is continuous at mu = 0. Far beyond the compressions that shocks reach (mu of
/// about 1 / Gamma), and deep in tension (below about 0.1 rho_0 without a floor), c^2 is negative.
/// Floor: matter/eos/pressure_floor.hpp.
struct MieGrueneisen {
  static constexpr char const* name = "mie_grueneisen";

  double reference_density = 1000.0;      // kg/m^3
  double reference_sound_speed = 1480.0;  // m/s, C
  double hugoniot_slope = 1.75;           // -, S
  double grueneisen_coefficient = 0.28;   // -, Gamma
  double reference_energy = 0.0;          // J/kg
  double least_pressure = 0.0;            // Pa, p_min

  /// a0 = rho_0 C^2 [Pa].
  MORAINE_HD double stiffness() const {
    return reference_density * reference_sound_speed * reference_sound_speed;
  }

  MORAINE_HD StateResponse respond(double rho, double e) const {
    SquaredResponse const response = evaluate(rho, e);
    return {response.pressure, signed_root(response.sound_speed_squared)};
  }

  MORAINE_HD double pressure(double rho, double e) const { return evaluate(rho, e).pressure; }

  MORAINE_HD double sound_speed_squared(double rho, double e) const {
    return evaluate(rho, e).sound_speed_squared;
  }

  MORAINE_HD double sound_speed(double rho, double e) const { return respond(rho, e).sound_speed; }

  /// Least density at which material of energy `e` [J/kg] has pressure `p` [Pa]: the largest at p =
  /// p_min. NaN for p < p_min, and where there is none up to 5 rho_0.
  MORAINE_HD double density_at_pressure(double p, double e) const {
    return p >= least_pressure ? density_without_floor(p, e) : std::nan("");
  }

  /// Energy at density `rho` [kg/m^3] and pressure `p` [Pa]; NaN for p < p_min. The reference
  /// energy where Gamma = 0, because every energy gives the same pressure.
  MORAINE_HD double energy_at_pressure(double rho, double p) const {
    if (!(p >= least_pressure)) return std::nan("");
    if (grueneisen_coefficient == 0.0) return reference_energy;
    return (p - without_floor(rho, 0.0).pressure) / (grueneisen_coefficient * rho);
  }

 private:
  MORAINE_HD SquaredResponse evaluate(double rho, double e) const {
    return with_floor(
        least_pressure, stiffness() / reference_density, rho, e,
        [this](double density, double energy) { return without_floor(density, energy); },
        [this](double p, double energy) { return density_without_floor(p, energy); });
  }

  MORAINE_HD SquaredResponse without_floor(double rho, double e) const {
    double const gamma = grueneisen_coefficient;
    double const mu = rho / reference_density - 1.0;
    double const steeper = hugoniot_slope - 1.0;
    double const square = mu > 0.0 ? 1.0 + 2.0 * steeper : 0.0;                 // b0 / a0
    double const cube = mu > 0.0 ? steeper * (2.0 + 3.0 * steeper) : 0.0;       // c0 / a0
    double const shock = stiffness() * mu * (1.0 + mu * (square + mu * cube));  // p_H
    double const slope = stiffness() * (1.0 + mu * (2.0 * square + 3.0 * mu * cube));
    double const p = (1.0 - 0.5 * gamma * mu) * shock + gamma * rho * e;
    double const by_density =
        ((1.0 - 0.5 * gamma * mu) * slope - 0.5 * gamma * shock) / reference_density + gamma * e;
    // dp/de = Gamma rho, so (p / rho^2) dp/de = Gamma p / rho.
    return {p, by_density + gamma * p / rho};
  }

  // In tension p is quadratic in mu; in compression look upwards in small steps, because p need not
  // rise everywhere.
  MORAINE_HD double density_without_floor(double p, double e) const {
    double const heat = grueneisen_coefficient * reference_density * e;
    double const linear = stiffness() + heat;
    if (!(linear > 0.0)) return std::nan("");
    if (p <= heat) {
      double const tension = heat - p;
      double const root =
          std::sqrt(linear * linear + 2.0 * grueneisen_coefficient * stiffness() * tension);
      double const mu = -2.0 * tension / (linear + root);
      return mu > -1.0 ? reference_density * (1.0 + mu) : std::nan("");
    }
    auto const excess = [this, p, e](double rho) { return without_floor(rho, e).pressure - p; };
    constexpr double step = 1.05;
    double low = reference_density;
    for (double high = low * step; high < 5.0 * reference_density; low = high, high *= step)
      if (excess(high) >= 0.0) return bisect(excess, low, high);
    return std::nan("");
  }
};

}  // namespace moraine
