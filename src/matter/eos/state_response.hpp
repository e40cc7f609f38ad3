// What every equation of state answers, and how it says that a state has no sound speed.
//
// An equation of state is an aggregate of its constants with these members, all usable on a device:
//   name                             as written in case files
//   reference_density, reference_energy   the undisturbed state
//   pressure(rho, e)                 [Pa]
//   sound_speed_squared(rho, e)      c^2 = dp/drho + (p / rho^2) dp/de   [m^2/s^2]
//   sound_speed(rho, e)              signed_root(c^2)                    [m/s]
//   respond(rho, e)                  pressure and sound speed at once, for the pass over particles
//   density_at_pressure(p, e), energy_at_pressure(rho, p)   inverses, for setup; NaN: no such state
// and, where the material can be the products of an explosive that burns by and by,
//   pressure_by_energy(rho)          dp/de                               [kg/m^3]
// and, where particles remember how far they have been compacted,
//   virgin_distension()              what they remember before           [-]
//   respond(rho, e, least)           pressure, c^2 and the new memory; the members above are those
//                                    of material that is loaded for the first time
// with density rho > 0 [kg/m^3] and specific energy e [J/kg]. Nothing here throws or branches on
// more than the state.
#pragma once

#include <cmath>

#include "base/macros.hpp"

namespace moraine {

/// Pressure and sound speed of one state.
struct StateResponse {
  double pressure;     // Pa, positive in compression
  double sound_speed;  // m/s; negative where c^2 < 0, see signed_root
};

/// sqrt(c2) for c2 >= 0, -sqrt(-c2) below: an equation of state that leaves its range of validity
/// (c^2 < 0, no real sound speed) gives a finite negative number instead of a NaN. Whoever reads a
/// sound speed must treat !(c >= 0) as an error of the particle that has it.
MORAINE_HD inline double signed_root(double c2) {
  return c2 >= 0.0 ? std::sqrt(c2) : -std::sqrt(-c2);
}

}  // namespace moraine
