// Mie-Grueneisen equation of state about a straight shock curve U_s = c_0 + s u_p, in closed form.
#pragma once

#include <cmath>
#include <limits>

#include "base/macros.hpp"
#include "matter/eos/pressure_floor.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Mie-Grueneisen about the Hugoniot line U_s = c_0 + s u_p.
///
///   p = rho_0 c_0^2 eta / (1 - s eta)^2 (1 - Gamma_0 eta / 2) + Gamma_0 rho_0 e
///   eta < 0 and s > 0:  p = rho_0 c_0^2 mu + Gamma_0 rho_0 e
///   p >= p_min,   eta = 1 - rho_0 / rho,   mu = rho / rho_0 - 1
///
/// Source: Meyers, Dynamic Behavior of Materials (1994), chapter 5; with Gamma rho = Gamma_0 rho_0.
/// Shocks from the undisturbed state with e = 0 and p = 0 follow the line exactly.
/// Symbols: c_0 reference_sound_speed, s hugoniot_slope, Gamma_0 grueneisen_coefficient, p_min
/// least_pressure.
/// Range: rho > 0 and s eta < 1. At and beyond s eta = 1 (limiting_density) no shock compresses the
/// material: the pressure is the largest number there is, and c^2 is negative. c is continuous at
/// eta = 0. In tension with s > 0 the line would turn back at eta = -1/s; mu takes its place.
/// Floor: matter/eos/pressure_floor.hpp.
struct UsUp {
  static constexpr char const* name = "us_up";

  double reference_density = 998.0;       // kg/m^3
  double reference_sound_speed = 1483.0;  // m/s, c_0
  double hugoniot_slope = 1.75;           // -, s
  double grueneisen_coefficient = 0.28;   // -, Gamma_0 at the reference density
  double reference_energy = 0.0;          // J/kg
  double least_pressure = 0.0;            // Pa, p_min

  /// rho_0 c_0^2 [Pa].
  MORAINE_HD double stiffness() const {
    return reference_density * reference_sound_speed * reference_sound_speed;
  }

  /// Density that no shock reaches, rho_0 s / (s - 1) [kg/m^3]: eta = 1/s. Infinite for s <= 1.
  MORAINE_HD double limiting_density() const {
    return hugoniot_slope > 1.0 ? reference_density * hugoniot_slope / (hugoniot_slope - 1.0)
                                : std::numeric_limits<double>::infinity();
  }

  MORAINE_HD StateResponse respond(double rho, double e) const {
    SquaredResponse const response = respond_squared(rho, e);
    return {response.pressure, signed_root(response.sound_speed_squared)};
  }

  /// Pressure and square of the sound speed at once.
  MORAINE_HD SquaredResponse respond_squared(double rho, double e) const {
    return with_floor(
        least_pressure, stiffness() / reference_density, rho, e,
        [this](double density, double energy) { return without_floor(density, energy); },
        [this](double p, double energy) { return density_without_floor(p, energy); });
  }

  MORAINE_HD double pressure(double rho, double e) const {
    return respond_squared(rho, e).pressure;
  }

  MORAINE_HD double sound_speed_squared(double rho, double e) const {
    return respond_squared(rho, e).sound_speed_squared;
  }

  MORAINE_HD double sound_speed(double rho, double e) const { return respond(rho, e).sound_speed; }

  /// Density at which material of energy `e` [J/kg] has pressure `p` [Pa]: the largest at p =
  /// p_min. NaN for p < p_min and where the law has no such state.
  MORAINE_HD double density_at_pressure(double p, double e) const {
    return p >= least_pressure ? density_without_floor(p, e) : std::nan("");
  }

  /// Energy at density `rho` [kg/m^3] and pressure `p` [Pa]; NaN for p < p_min and from the
  /// limiting density on. The reference energy where Gamma_0 = 0, because every energy gives the
  /// same pressure.
  MORAINE_HD double energy_at_pressure(double rho, double p) const {
    if (!(p >= least_pressure && rho < limiting_density())) return std::nan("");
    if (grueneisen_coefficient == 0.0) return reference_energy;
    return (p - without_floor(rho, 0.0).pressure) / (grueneisen_coefficient * reference_density);
  }

 private:
  MORAINE_HD SquaredResponse without_floor(double rho, double e) const {
    double const s = hugoniot_slope;
    double const gamma = grueneisen_coefficient;
    double const heat = gamma * reference_density * e;
    double const eta = 1.0 - reference_density / rho;
    double const expanded = reference_density / rho;  // d eta / d rho = rho_0 / rho^2
    if (eta < 0.0 && s > 0.0) {
      double const p = stiffness() * (rho / reference_density - 1.0) + heat;
      return {
          p, stiffness() / reference_density + gamma * p * expanded * expanded / reference_density};
    }
    double const room = 1.0 - s * eta;
    if (!(room > 0.0))
      return {std::numeric_limits<double>::max(), -stiffness() / reference_density};
    double const shock = stiffness() * eta / (room * room);
    double const slope = stiffness() * (1.0 + s * eta) / (room * room * room);
    double const p = shock * (1.0 - 0.5 * gamma * eta) + heat;
    double const by_eta = slope * (1.0 - 0.5 * gamma * eta) - 0.5 * gamma * shock;
    // dp/de = Gamma_0 rho_0; both terms of c^2 have the factor rho_0 / rho^2.
    return {p, (by_eta + gamma * p) * expanded * expanded / reference_density};
  }

  // Quadratic in eta: P (1 - s eta)^2 = rho_0 c_0^2 (eta - Gamma_0 eta^2 / 2), P = p - Gamma_0
  // rho_0 e; the root that is 0 for P = 0.
  MORAINE_HD double density_without_floor(double p, double e) const {
    double const a = stiffness();
    double const cold = p - grueneisen_coefficient * reference_density * e;
    if (cold < 0.0 && hugoniot_slope > 0.0)
      return cold > -a ? reference_density * (1.0 + cold / a) : std::nan("");
    double const square = a * a + 2.0 * cold * a * (2.0 * hugoniot_slope - grueneisen_coefficient);
    if (!(square >= 0.0)) return std::nan("");
    double const eta = 2.0 * cold / (2.0 * cold * hugoniot_slope + a + std::sqrt(square));
    return reference_density / (1.0 - eta);
  }
};

}  // namespace moraine
