// Exact solution of the Riemann problem for an ideal gas.
#pragma once

#include "exact/flow_state.hpp"

namespace moraine {

/// Uniform gas on one side of the initial discontinuity.
struct GasState {
  double density = 0.0;   // kg/m^3
  double velocity = 0.0;  // m/s
  double pressure = 0.0;  // Pa
};

/// Two uniform states of one ideal gas that touch at x = 0, t = 0; the solution depends on x/t
/// alone. Source: Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed. (2009),
/// chapter 4; equation numbers in the code are his.
///
/// Range: density and pressure positive, heat capacity ratio above 1, and no vacuum between the
/// states: u_right - u_left < 2 (c_left + c_right) / (gamma - 1), eq. (4.40). Otherwise the
/// constructor throws std::invalid_argument.
class RiemannIdealGas {
 public:
  RiemannIdealGas(GasState const& left, GasState const& right, double heat_capacity_ratio);

  /// Pressure between the two nonlinear waves [Pa].
  double star_pressure() const { return star_pressure_; }
  /// Velocity of the contact [m/s].
  double star_velocity() const { return star_velocity_; }

  /// The state on the ray x/t [m/s]; on a shock or the contact, that of its right side.
  FlowState sample(double x_over_t) const;

 private:
  double gamma_;
  GasState left_;
  GasState right_;
  double star_pressure_ = 0.0;
  double star_velocity_ = 0.0;
};

}  // namespace moraine
