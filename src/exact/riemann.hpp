// Exact solution of the Riemann problem for any two materials.
#pragma once

#include <optional>

#include "exact/wave_curve.hpp"

namespace moraine {

/// Uniform material on one side of the initial discontinuity.
struct RiemannSide {
  Law law;
  double density = 0.0;          // kg/m^3
  double velocity = 0.0;         // m/s
  double specific_energy = 0.0;  // J/kg
};

/// Two uniform materials that touch at x = 0, t = 0; the solution depends on x/t alone. A wave runs
/// into each of them, and between the waves stands the contact, with one pressure and velocity:
///
///   u_left - v_left(p) = u_right + v_right(p)
///
/// with v(p) the velocity that a wave to pressure p gives (WaveCurve). Its unique root is bisected
/// to the last bit. Source: Menikoff and Plohr, Rev. Mod. Phys. 61 (1989) 75, section III; for
/// gases Toro, Riemann Solvers, 3rd ed. (2009), eq. (4.5). Pressures below zero (tension) are
/// solutions where the laws have them: the contact is glued.
///
/// Throws std::invalid_argument for states without density or sound speed; std::domain_error where
/// the states move apart faster than their materials can follow (a vacuum, or cavitation where a
/// law has a floor of pressure), and what the waves throw.
class RiemannProblem {
 public:
  RiemannProblem(RiemannSide const& left, RiemannSide const& right);

  /// Material on the left, nothing on the right: it expands to pressure zero, or to the end of its
  /// isentrope if that is above.
  static RiemannProblem into_vacuum(RiemannSide const& left);

  /// Pressure between the two waves [Pa].
  double star_pressure() const { return star_pressure_; }
  /// Velocity of the contact, or of the surface towards the vacuum [m/s].
  double star_velocity() const { return star_velocity_; }
  Wave const& left_wave() const { return left_wave_; }
  /// Nothing where there is a vacuum.
  std::optional<Wave> const& right_wave() const { return right_wave_; }

  /// The state on the ray x/t [m/s]; on a shock or the contact, that of its right side. Zero in a
  /// vacuum.
  FlowState sample(double x_over_t) const;

 private:
  RiemannProblem(RiemannSide const& left, std::optional<RiemannSide> const& right);

  WaveCurve left_;
  std::optional<WaveCurve> right_;
  double left_velocity_;
  double right_velocity_ = 0.0;
  double star_pressure_ = 0.0;
  double star_velocity_ = 0.0;
  Wave left_wave_{};
  std::optional<Wave> right_wave_;
};

}  // namespace moraine
