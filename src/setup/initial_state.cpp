#include "setup/initial_state.hpp"

#include <algorithm>
#include <cmath>

#include "setup/geometry.hpp"

namespace moraine {
namespace {

template <class Law>
std::optional<MaterialState> state_at_pressure(Law const& law, InitialState const& initial,
                                               double pressure) {
  MaterialState state{initial.density.value_or(law.reference_density),
                      initial.specific_energy.value_or(law.reference_energy)};
  if (initial.density)
    state.specific_energy = law.energy_at_pressure(state.density, pressure);
  else
    state.density = law.density_at_pressure(pressure, state.specific_energy);
  if (!(state.density > 0.0) || !std::isfinite(state.specific_energy)) return std::nullopt;
  // A law whose pressure does not depend on energy cannot meet a pressure at a given density.
  double const found = law.pressure(state.density, state.specific_energy);
  double const c = law.sound_speed(state.density, state.specific_energy);
  // Rounding of the density alone moves the pressure by about 1e-16 rho c^2.
  double const tolerance = 1e-9 * std::abs(pressure) + 1e-12 * state.density * c * c;
  if (!(std::abs(found - pressure) <= tolerance)) return std::nullopt;
  return state;
}

}  // namespace

double hydrostatic_pressure(double reference_density, double level, Point const& position,
                            Point const& gravity) {
  double const g = length(gravity);
  double along_gravity = 0.0;  // g . x = -|g| z
  for (std::size_t axis = 0; axis < 3; ++axis) along_gravity += gravity[axis] * position[axis];
  return std::max(0.0, reference_density * (g * level + along_gravity));
}

std::optional<MaterialState> initial_state(Eos const& eos, InitialState const& initial,
                                           Point const& position, Point const& gravity) {
  std::optional<double> pressure = initial.pressure;
  if (initial.hydrostatic_level)
    pressure =
        hydrostatic_pressure(reference_density(eos), *initial.hydrostatic_level, position, gravity);
  if (!pressure)
    return MaterialState{initial.density.value_or(reference_density(eos)),
                         initial.specific_energy.value_or(reference_energy(eos))};
  return std::visit([&](auto const& law) { return state_at_pressure(law, initial, *pressure); },
                    eos);
}

Point initial_velocity(InitialState const& initial, Point const& position) {
  Point velocity = initial.velocity;
  auto const& formulas = initial.velocity_field.formulas;
  for (std::size_t axis = 0; axis < formulas.size(); ++axis)
    velocity[axis] += formulas[axis](position);
  Rotation const& rotation = initial.rotation;
  if (!rotation.rate) return velocity;
  Point const turn = scale(*rotation.rate / length(rotation.axis), rotation.axis);
  return add(velocity, cross(turn, subtract(position, rotation.center)));
}

}  // namespace moraine
