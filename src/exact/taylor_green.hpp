// The decaying vortices of Taylor and Green.
#pragma once

namespace moraine {

/// Periodic array of vortices in two dimensions, an exact solution of the Navier-Stokes equations
/// of an incompressible liquid; k = 2 pi / L:
///
///   u = -U cos(kx) sin(ky) F,   v = U sin(kx) cos(ky) F,   F = exp(-2 nu k^2 t)
///   p = -rho U^2 (cos(2kx) + cos(2ky)) F^2 / 4
///
/// Source: Taylor and Green, Proc. R. Soc. Lond. A 158 (1937) 499; the form in two dimensions:
/// Taylor, Phil. Mag. 46 (1923) 671.
struct TaylorGreen {
  double length = 1.0;                // m, L, of the periodic square
  double kinematic_viscosity = 0.01;  // m^2/s, nu
  double speed = 1.0;                 // m/s, U, the largest at t = 0
  double density = 1.0;               // kg/m^3

  struct Sample {
    double velocity_x;  // m/s
    double velocity_y;  // m/s
    double pressure;    // Pa, mean zero
  };

  /// Throws std::invalid_argument for a length or density not positive, a negative viscosity.
  void check() const;
  double wave_number() const;  // 1/m
  /// Rate at which velocities decay, 2 nu k^2 [1/s]; energies decay twice as fast.
  double decay_rate() const;
  Sample sample(double x, double y, double time) const;
  /// Kinetic energy per area of the square at unit thickness [J/m^3], rho U^2 F^2 / 4.
  double mean_energy(double time) const;
};

}  // namespace moraine
