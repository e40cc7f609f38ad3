// Noh's implosion.
#pragma once

#include "exact/flow_geometry.hpp"
#include "exact/flow_state.hpp"

namespace moraine {

/// Cold ideal gas that streams towards the origin and is stopped there by a strong shock:
///
///   shock at r_s = (gamma - 1) u_0 t / 2
///   r < r_s:  rho = rho_0 ((gamma+1)/(gamma-1))^d,  u = 0,  e = u_0^2 / 2,  p = (gamma-1) rho e
///   r > r_s:  rho = rho_0 (1 + u_0 t / r)^(d-1),    u = -u_0,  e = 0
///
/// Source: Noh, J. Comput. Phys. 72 (1987) 78, section 4; equations as in Timmes, Gisler and Hrbek,
/// LA-UR-05-6865 (2005), section on Noh's problem.
struct Noh {
  FlowGeometry geometry = FlowGeometry::spherical;
  double heat_capacity_ratio = 5.0 / 3.0;  // -, above 1
  double density = 1.0;                    // kg/m^3, at t = 0
  double speed = 1.0;                      // m/s, towards the origin

  /// Throws std::invalid_argument for a ratio not above 1, a density or speed not above 0.
  void check() const;
  double shock_position(double time) const;
  /// Density behind the shock [kg/m^3].
  double stagnation_density() const;
  /// At distance `r` >= 0 from the origin and `time` >= 0; on the shock, the state ahead.
  FlowState sample(double r, double time) const;
};

}  // namespace moraine
