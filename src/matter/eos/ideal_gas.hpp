// Ideal gas with constant heat capacities.
#pragma once

#include <cmath>

#include "base/macros.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Ideal gas.
///
///   p = (gamma - 1) rho e,   c^2 = gamma p / rho = gamma (gamma - 1) e
///
/// Source: Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed. (2009),
/// chapter 1. Symbols: gamma heat_capacity_ratio. Range: rho > 0, e >= 0; below, p and c^2 are
/// negative. The reference state is air at 15 degC and one atmosphere.
struct IdealGas {
  static constexpr char const* name = "ideal_gas";

  double reference_density = 1.225;      // kg/m^3
  double heat_capacity_ratio = 1.4;      // -, above 1
  double reference_energy = 206785.714;  // J/kg

  MORAINE_HD double pressure(double rho, double e) const {
    return (heat_capacity_ratio - 1.0) * rho * e;
  }

  MORAINE_HD double sound_speed_squared(double /*rho*/, double e) const {
    return heat_capacity_ratio * (heat_capacity_ratio - 1.0) * e;
  }

  MORAINE_HD double sound_speed(double rho, double e) const {
    return signed_root(sound_speed_squared(rho, e));
  }

  /// dp/de = (gamma - 1) rho [kg/m^3].
  MORAINE_HD double pressure_by_energy(double rho) const {
    return (heat_capacity_ratio - 1.0) * rho;
  }

  MORAINE_HD StateResponse respond(double rho, double e) const {
    return {pressure(rho, e), sound_speed(rho, e)};
  }

  /// Density at pressure `p` [Pa] and energy `e` [J/kg]; NaN where they differ in sign or either is
  /// zero.
  MORAINE_HD double density_at_pressure(double p, double e) const {
    double const rho = p / ((heat_capacity_ratio - 1.0) * e);
    return rho > 0.0 && e != 0.0 ? rho : std::nan("");
  }

  /// Energy at density `rho` [kg/m^3] and pressure `p` [Pa].
  MORAINE_HD double energy_at_pressure(double rho, double p) const {
    return p / ((heat_capacity_ratio - 1.0) * rho);
  }
};

}  // namespace moraine
