// Polynomial equation of state of water, with a cavitation floor.
#pragma once

#include <cmath>

#include "base/macros.hpp"
#include "matter/eos/pressure_floor.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Water under shock loading.
///
///   mu >= 0:  p = a1 mu + a2 mu^2 + a3 mu^3 + (b0 + b1 mu + b1 mu^2) rho_0 e
///   mu < 0:   p = a1 mu + (b0 + b1 mu) rho_0 e
///   p >= p_cav,   mu = rho / rho_0 - 1
///
/// Source: Liu and Liu, Smoothed Particle Hydrodynamics (2003), chapter 8, after Steinberg
/// (1987).
/// Symbols: a1, a2, a3 [Pa], b0, b1 [-], rho_0 reference_density, p_cav cavitation_pressure.
/// Range: rho > 0. c is continuous at mu = 0.
/// Cavitation: where the law gives less than p_cav, the pressure is p_cav and the sound speed is
/// that of the state in which the floor is met at the same energy. Below e = -a1 / (b1 rho_0) the
/// floor is met nowhere, and c^2 is -a1 / rho_0 as a sign of the invalid state. a1 is 2.19e9 Pa,
/// which gives the sound speed of 1480 m/s that the source states and its 2.1e9 Pa does not.
struct WaterPolynomial {
  static constexpr char const* name = "water_polynomial";

  double reference_density = 1000.0;  // kg/m^3
  double a1 = 2.19e9;                 // Pa
  double a2 = 9.224e9;                // Pa
  double a3 = 8.767e9;                // Pa
  double b0 = 0.4934;                 // -
  double b1 = 1.3937;                 // -
  double reference_energy = 357.1;    // J/kg; 205.4 gives one atmosphere at the reference density
  double cavitation_pressure = 0.0;   // Pa

  MORAINE_HD StateResponse respond(double rho, double e) const {
    SquaredResponse const response = evaluate(rho, e);
    return {response.pressure, signed_root(response.sound_speed_squared)};
  }

  MORAINE_HD double pressure(double rho, double e) const { return evaluate(rho, e).pressure; }

  MORAINE_HD double sound_speed_squared(double rho, double e) const {
    return evaluate(rho, e).sound_speed_squared;
  }

  MORAINE_HD double sound_speed(double rho, double e) const { return respond(rho, e).sound_speed; }

  /// Density at which water of energy `e` [J/kg] has pressure `p` [Pa]: the largest at p = p_cav.
  /// NaN for p < p_cav and where the law has no such state (p falls with density at this energy,
  /// or the density would not be positive).
  MORAINE_HD double density_at_pressure(double p, double e) const {
    return p >= cavitation_pressure ? density_without_floor(p, e) : std::nan("");
  }

  /// Energy at density `rho` [kg/m^3] and pressure `p` [Pa]. NaN for p < p_cav and for
  /// mu <= -b0 / b1, where heating does not raise the pressure.
  MORAINE_HD double energy_at_pressure(double rho, double p) const {
    double const mu = rho / reference_density - 1.0;
    double const factor = mu > 0.0 ? b0 + b1 * mu + b1 * mu * mu : b0 + b1 * mu;
    double const cold = mu > 0.0 ? mu * (a1 + mu * (a2 + mu * a3)) : a1 * mu;
    if (!(p >= cavitation_pressure && factor > 0.0)) return std::nan("");
    return (p - cold) / (factor * reference_density);
  }

 private:
  MORAINE_HD SquaredResponse evaluate(double rho, double e) const {
    return with_floor(
        cavitation_pressure, a1 / reference_density, rho, e,
        [this](double density, double energy) { return without_floor(density, energy); },
        [this](double p, double energy) { return density_without_floor(p, energy); });
  }

  MORAINE_HD SquaredResponse without_floor(double rho, double e) const {
    double const mu = rho / reference_density - 1.0;
    double const heat = reference_density * e;
    double p = a1 * mu + (b0 + b1 * mu) * heat;
    double slope = a1 + b1 * heat;  // dp/dmu
    double factor = b0 + b1 * mu;   // dp/de = factor rho_0
    if (mu > 0.0) {
      p += mu * mu * (a2 + mu * a3 + b1 * heat);
      slope += mu * (2.0 * a2 + 3.0 * mu * a3 + 2.0 * b1 * heat);
      factor += b1 * mu * mu;
    }
    return {p, slope / reference_density + p * factor * reference_density / (rho * rho)};
  }

  // Linear in tension; in compression Newton's method from the linear estimate. p is convex in mu
  // (e >= 0) or barely concave (small negative e): in both cases the iterates approach the root
  // from one side. NaN where p does not rise with density.
  MORAINE_HD double density_without_floor(double p, double e) const {
    double const heat = reference_density * e;
    double const linear = a1 + b1 * heat;
    double const square = a2 + b1 * heat;
    if (!(linear > 0.0)) return std::nan("");
    double mu = (p - b0 * heat) / linear;
    bool converged = mu <= 0.0;
    for (int iteration = 0; !converged && iteration < 60; ++iteration) {
      double const excess = b0 * heat - p + mu * (linear + mu * (square + mu * a3));
      double const slope = linear + mu * (2.0 * square + 3.0 * mu * a3);
      if (!(slope > 0.0)) return std::nan("");
      double const step = excess / slope;
      mu -= step;
      converged = std::fabs(step) <= 4e-16 * (1.0 + mu);
    }
    return mu > -1.0 ? reference_density * (1.0 + mu) : std::nan("");
  }
};

}  // namespace moraine
