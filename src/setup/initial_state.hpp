// Density and energy that the particles of a region start with.
#pragma once

#include <optional>

#include "matter/eos/eos.hpp"
#include "setup/case.hpp"

namespace moraine {

struct MaterialState {
  double density;          // kg/m^3
  double specific_energy;  // J/kg
};

/// Hydrostatic pressure p = max(0, rho_0 |g| (level - z)) [Pa], where z is the coordinate of
/// `position` against gravity g [m/s^2] and `level` [m] that of the free surface. On an even
/// lattice this takes the density as constant over the depth, exact to the order of p / (rho_0
/// c_0^2); for a lattice that is then compressed (setup/hydrostatic_layers.hpp) it is the weight
/// above, exactly.
double hydrostatic_pressure(double reference_density, double level, Point const& position,
                            Point const& gravity);

/// The state at a place. With a pressure and a density the energy is solved for, with a pressure
/// (or a hydrostatic level) the density; what is still missing is the material's reference value.
/// Nothing if the material has no such state: the equation of state cannot give the pressure.
std::optional<MaterialState> initial_state(Eos const& eos, InitialState const& initial,
                                           Point const& position, Point const& gravity);

/// Velocity at a place: v + rate unit(axis) x (x - center) [m/s].
Point initial_velocity(InitialState const& initial, Point const& position);

}  // namespace moraine
