// Viscous flow between two plates that starts from rest.
#pragma once

namespace moraine {

/// Liquid between plates y = 0 and y = width, at rest at t = 0. Incompressible and laminar: the
/// velocity along the plates depends on y and t alone, du/dt = nu d2u/dy2 + f.

/// The plate y = width moves from t = 0 with `plate_speed` U.
///
///   u = U y/L + sum_n 2U/(n pi) (-1)^n sin(n pi y/L) exp(-(n pi)^2 nu t/L^2),   n = 1, 2, ...
///
/// Source: Morris, Fox and Zhu, J. Comput. Phys. 136 (1997) 214, on Couette flow; Batchelor, An
/// Introduction to Fluid Dynamics (1967), section 4.3.
struct CouetteFlow {
  double width = 1e-3;                // m, L
  double kinematic_viscosity = 1e-6;  // m^2/s, nu
  double plate_speed = 1e-3;          // m/s, U

  /// Throws std::invalid_argument for a width or viscosity that is not positive.
  void check() const;
  /// Velocity [m/s] at 0 <= y <= width and t >= 0.
  double velocity(double y, double time) const;
  double steady_velocity(double y) const;
};

/// A force per mass f along the plates acts from t = 0 (a pressure gradient of -rho f does the
/// same).
///
///   u = f/(2 nu) y (L - y)
///       - sum_n 4 f L^2/(nu (n pi)^3) sin(n pi y/L) exp(-(n pi)^2 nu t/L^2),   n = 1, 3, 5, ...
///
/// Source: Morris, Fox and Zhu, J. Comput. Phys. 136 (1997) 214, on Poiseuille flow.
struct PoiseuilleFlow {
  double width = 1e-3;                // m, L
  double kinematic_viscosity = 1e-6;  // m^2/s, nu
  double force = 1e-4;                // m/s^2, f, force per mass

  void check() const;
  double velocity(double y, double time) const;
  double steady_velocity(double y) const;
};

}  // namespace moraine
