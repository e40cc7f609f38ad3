// Laws that only comparisons need.
#pragma once

#include <cmath>

namespace moraine {

/// p = (gamma - 1) rho e - gamma p_inf, the stiffened gas of many published shock tubes.
struct StiffenedGas {
  double gamma;
  double p_inf;  // Pa

  double pressure(double rho, double e) const { return (gamma - 1.0) * rho * e - gamma * p_inf; }
  double sound_speed_squared(double rho, double e) const {
    return gamma * (pressure(rho, e) + p_inf) / rho;
  }
  double energy_at_pressure(double rho, double p) const {
    return (p + gamma * p_inf) / ((gamma - 1.0) * rho);
  }
};

/// Water by its Hugoniot from 1000 kg/m^3 and e = 0, U = c0 + S1 u + S2 (u/U) u + S3 (u/U)^2 u
/// (Steinberg, UCRL-MA-106439): u/U = 1 - rho_0/rho is the strain, so that
/// U = c0 / (1 - x (S1 + S2 x + S3 x^2)). Off the Hugoniot p = p_H + Gamma rho_0 (e - e_H).
struct SteinbergWater {
  static constexpr double rho_0 = 1000.0, c_0 = 1480.0, s_1 = 2.56, s_2 = -1.986, s_3 = 0.2268,
                          gruneisen = 0.5;

  double pressure(double rho, double e) const {
    double const x = 1.0 - rho_0 / rho;
    double const speed = c_0 / (1.0 - x * (s_1 + x * (s_2 + x * s_3)));
    double const p_h = rho_0 * speed * speed * x;
    return p_h + gruneisen * rho_0 * (e - 0.5 * p_h * x / rho_0);
  }
  /// By differences along the adiabat; good to about eight digits.
  double sound_speed_squared(double rho, double e) const {
    double const step = 1e-5 * rho;
    double const heat = pressure(rho, e) / (rho * rho) * step;
    return (pressure(rho + step, e + heat) - pressure(rho - step, e - heat)) / (2.0 * step);
  }
};

}  // namespace moraine
