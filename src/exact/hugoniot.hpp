// The state behind a shock in any material.
#pragma once

#include <vector>

#include "exact/law.hpp"

namespace moraine {

/// The state behind a shock that runs into material at rest.
struct ShockState {
  double shock_speed;      // m/s, into the material ahead
  double density;          // kg/m^3
  double pressure;         // Pa
  double specific_energy;  // J/kg
};

/// Shock ahead of a piston that moves with `piston_velocity` u into material at rest with density
/// `density` rho_0 and specific energy `specific_energy` e_0.
///
/// Rankine-Hugoniot conditions with shock speed U:
///   rho (U - u) = rho_0 U,   p = p_0 + rho_0 U u,   e = e_0 + p_0 u / (rho_0 U) + u^2 / 2
/// U is where the pressure of the equation of state at (rho, e) equals p: the largest such U is
/// taken, the branch that starts at the sound speed of the material ahead for u = 0.
/// Source: Zel'dovich and Raizer, Physics of Shock Waves and High-Temperature Hydrodynamic
/// Phenomena (1966), chapter I, section 13.
/// Range: u >= 0 and finite, rho_0 > 0 and a real sound speed ahead, else std::invalid_argument;
/// without a solution up to a compression of 1e6 std::domain_error.
ShockState shock_from_piston(Law const& law, double density, double specific_energy,
                             double piston_velocity);

/// A shock and the velocity behind it.
struct ShockWave {
  ShockState behind;
  double piston_velocity;  // m/s, of the material behind
};

/// Shock with pressure `pressure` p behind it, into material at rest:
///
///   e - e_0 = (p + p_0) (1/rho_0 - 1/rho) / 2,   u^2 = (p - p_0) (1/rho_0 - 1/rho)
///
/// the first compression that satisfies the equation of state. Source as above, eq. (1.71).
/// Range: p >= p_0, else std::invalid_argument; errors as above.
ShockWave shock_to_pressure(Law const& law, double density, double specific_energy,
                            double pressure);

/// The Rankine-Hugoniot curve: `count` shocks of equidistant piston velocities up to
/// `fastest_piston`, the first of them a sound wave. Ends before the first piston velocity for
/// which the law has no shock.
std::vector<ShockWave> hugoniot_curve(Law const& law, double density, double specific_energy,
                                      double fastest_piston, int count);

}  // namespace moraine
