// Jones-Wilkins-Lee equation of state: the products of a detonation.
#pragma once

#include <cmath>

#include "base/bisect.hpp"
#include "base/macros.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Detonation products; the default is TNT.
///
///   p = A (1 - omega eta / R1) exp(-R1 / eta)
///     + B (1 - omega eta / R2) exp(-R2 / eta) + omega rho e
///
///   eta = rho / rho_0
///
/// Source: Dobratz and Crawford, LLNL Explosives Handbook, UCRL-52997 (1985); Liu and Liu, Smoothed
/// Particle Hydrodynamics (2003), chapter 8, where A = 3.712e11 Pa for TNT.
/// Symbols: A, B [Pa], R1, R2, omega [-], rho_0 reference_density.
/// Range: rho > 0. These are burnt products: detonation_velocity has no part in their pressure. It
/// is the speed at which programmed burn (matter/burn/programmed_burn.hpp) makes them.
struct Jwl {
  static constexpr char const* name = "jwl";

  double reference_density = 1630.0;    // kg/m^3, of the solid explosive
  double a = 3.712e11;                  // Pa
  double b = 3.231e9;                   // Pa
  double r1 = 4.15;                     // -
  double r2 = 0.95;                     // -
  double omega = 0.30;                  // -
  double reference_energy = 4.29e6;     // J/kg
  double detonation_velocity = 6930.0;  // m/s

  MORAINE_HD StateResponse respond(double rho, double e) const {
    Response const response = evaluate(rho, e);
    return {response.pressure, signed_root(response.sound_speed_squared)};
  }

  MORAINE_HD double pressure(double rho, double e) const { return evaluate(rho, e).pressure; }

  MORAINE_HD double sound_speed_squared(double rho, double e) const {
    return evaluate(rho, e).sound_speed_squared;
  }

  MORAINE_HD double sound_speed(double rho, double e) const { return respond(rho, e).sound_speed; }

  /// dp/de = omega rho [kg/m^3].
  MORAINE_HD double pressure_by_energy(double rho) const { return omega * rho; }

  /// Least density at which products of energy `e` [J/kg] have pressure `p` [Pa]; NaN if there is
  /// none between 1e-9 and 5 reference densities.
  MORAINE_HD double density_at_pressure(double p, double e) const {
    auto const excess = [this, p, e](double rho) { return pressure(rho, e) - p; };
    double low = 1e-9 * reference_density;
    if (!(excess(low) < 0.0)) return std::nan("");
    // At small energy the pressure need not rise everywhere: look upwards in small steps.
    constexpr double step = 1.1;
    for (double high = low * step; high < 5.0 * reference_density; low = high, high *= step)
      if (excess(high) >= 0.0) return bisect(excess, low, high);
    return std::nan("");
  }

  /// Energy at density `rho` [kg/m^3] and pressure `p` [Pa].
  MORAINE_HD double energy_at_pressure(double rho, double p) const {
    return (p - pressure(rho, 0.0)) / (omega * rho);
  }

 private:
  struct Response {
    double pressure;
    double sound_speed_squared;
  };
  struct Exponential {
    double value;  // Pa
    double slope;  // Pa, by eta
  };

  // factor (1 - omega eta / r) exp(-r / eta) and its derivative by eta
  MORAINE_HD Exponential exponential(double factor, double r, double eta) const {
    double const decay = factor * std::exp(-r / eta);
    double const bracket = 1.0 - omega * eta / r;
    return {decay * bracket, decay * (bracket * r / (eta * eta) - omega / r)};
  }

  MORAINE_HD Response evaluate(double rho, double e) const {
    double const eta = rho / reference_density;
    Exponential const first = exponential(a, r1, eta);
    Exponential const second = exponential(b, r2, eta);
    double const p = first.value + second.value + omega * rho * e;
    // dp/de = omega rho, so (p / rho^2) dp/de = omega p / rho.
    double const c2 =
        (first.slope + second.slope) / reference_density + omega * e + omega * p / rho;
    return {p, c2};
  }
};

}  // namespace moraine
