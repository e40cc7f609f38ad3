// Shock fronts in air as an ideal gas, and what a rigid wall makes of them.
#pragma once

namespace moraine::blast {

/// Air ahead of a front.
struct Air {
  double pressure;  // Pa
  double density;   // kg/m^3

  double sound_speed() const;  // m/s, sqrt(gamma p/rho)
};

/// Rankine-Hugoniot conditions for gamma = 1.4 at an overpressure p [Pa], air at rest ahead:
///   U = c sqrt(1 + 6p/7p_a),  u = c (5p/7p_a)/sqrt(1 + 6p/7p_a),  q = rho u^2/2 = (5/2)
///   p^2/(7p_a+p)
/// U speed of the front, u speed of the air behind it [m/s], c^2 = gamma p_a/rho_a.
/// Exact for the ideal gas. Above p/p_a of about 40 the vibration and dissociation of the molecules
/// show: at p/p_a = 38 the normal reflection is 10 % below Kingery and Bulmash.
double front_speed(double overpressure, Air const& air);
double particle_speed(double overpressure, Air const& air);
double dynamic_pressure(double overpressure, Air const& air);  // Pa

/// Overpressure behind a front that is thrown back by a rigid wall parallel to it [Pa]:
///   p_r = 2p (7p_a + 4p)/(7p_a + p), from 2p for weak to 8p for strong fronts.
double normal_reflection(double overpressure, double ambient_pressure);

}  // namespace moraine::blast
