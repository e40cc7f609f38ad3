// A floor below which the pressure of a material does not fall: cavitation, or spall.
#pragma once

#include "base/macros.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Pressure and square of the sound speed of one state.
struct SquaredResponse {
  double pressure;             // Pa
  double sound_speed_squared;  // m^2/s^2; negative where the state has no sound speed
};

/// What a law answers that may not fall below the pressure `floor` [Pa].
///
///   p = max(p_free, floor)
///
/// At the floor the sound speed is frozen: it is that of the state in which the law meets the floor
/// at the same energy. Where it meets it nowhere, c^2 is -`stiffness` as a sign of the invalid
/// state. `free(rho, e)` is the law without a floor, `density_at(p, e)` the density at which that
/// has a pressure, NaN where it never has.
template <class Free, class DensityAt>
MORAINE_HD SquaredResponse with_floor(double floor, double stiffness, double rho, double e,
                                      Free&& free, DensityAt&& density_at) {
  SquaredResponse const response = free(rho, e);
  if (!(response.pressure < floor)) return response;
  double const met = density_at(floor, e);
  return {floor, met > 0.0 ? free(met, e).sound_speed_squared : -stiffness};
}

}  // namespace moraine
