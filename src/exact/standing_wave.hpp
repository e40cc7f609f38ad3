// A small standing wave on a liquid.
#pragma once

namespace moraine {

/// Linear gravity wave between two walls (or planes of symmetry) half a wave length apart, on
/// liquid of depth d over a flat bed; k = 2 pi / wave length, z = 0 the surface at rest:
///
///   eta = a cos(kx) cos(w t) F,   w^2 = g k tanh(k d),   F = exp(-2 nu k^2 t)
///   u = (a g k / w) cosh(k(z+d)) / cosh(k d) sin(kx) sin(w t) F
///   v = -(a g k / w) sinh(k(z+d)) / cosh(k d) cos(kx) sin(w t) F
///   p = -rho g z + rho g a cosh(k(z+d)) / cosh(k d) cos(kx) cos(w t) F
///
/// Source: Lamb, Hydrodynamics, 6th ed. (1932), art. 228; the decay in art. 348, for waves on deep
/// liquid of little viscosity and for walls and a bed with free slip.
/// Range: a k << 1; nu k^2 << w. The frequency is that without viscosity: the shift is of the order
/// (nu k^2 / w)^2.
struct StandingWave {
  double wave_length = 2.0;          // m
  double depth = 1.0;                // m, d
  double amplitude = 0.01;           // m, a
  double gravity = 9.81;             // m/s^2, g
  double kinematic_viscosity = 0.0;  // m^2/s, nu
  double density = 1000.0;           // kg/m^3

  struct Sample {
    double velocity_x;  // m/s
    double velocity_z;  // m/s, upwards
    double pressure;    // Pa, above that of the air
  };

  /// Throws std::invalid_argument for lengths, gravity or density that are not positive and for a
  /// negative viscosity.
  void check() const;
  double wave_number() const;        // 1/m, k
  double angular_frequency() const;  // rad/s, w
  double period() const;             // s
  double decay_rate() const;         // 1/s, 2 nu k^2, of amplitudes
  /// Height of the surface above z = 0 [m].
  double elevation(double x, double time) const;
  /// At -depth <= z <= 0.
  Sample sample(double x, double z, double time) const;
  /// Kinetic plus potential energy of one wave length per metre of crest [J/m] at t = 0,
  /// rho g a^2 (wave length) / 4.
  double energy() const;
};

}  // namespace moraine
