#include "exact/wave_curve.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "exact/hugoniot.hpp"

namespace moraine {
namespace {

FlowState flow_state(IsentropeState const& at) {
  return {at.density, -at.velocity_change, at.pressure, at.specific_energy};
}

}  // namespace

WaveCurve::WaveCurve(Law law, double density, double specific_energy)
    : law_(std::move(law)),
      isentrope_(law_, density, specific_energy),
      ahead_{density, 0.0, isentrope_.start().pressure, specific_energy} {}

IsentropeState WaveCurve::expanded(double pressure) const {
  return pressure > isentrope_.end().pressure ? isentrope_.at_pressure(pressure) : isentrope_.end();
}

double WaveCurve::velocity(double pressure) const {
  if (pressure > ahead_.pressure)
    return shock_to_pressure(law_, ahead_.density, ahead_.specific_energy, pressure)
        .piston_velocity;
  return -expanded(pressure).velocity_change;
}

Wave WaveCurve::wave(double pressure) const {
  if (pressure > ahead_.pressure) {
    auto const [shock, u] =
        shock_to_pressure(law_, ahead_.density, ahead_.specific_energy, pressure);
    if (shock.shock_speed < (1.0 - 1e-6) * isentrope_.start().sound_speed)
      throw std::domain_error(
          "wave: a shock of this pressure would split, sound would run ahead of it");
    return {WaveKind::shock,
            shock.shock_speed,
            shock.shock_speed,
            {shock.density, u, shock.pressure, shock.specific_energy}};
  }
  IsentropeState const at = expanded(pressure);
  if (!isentrope_.spreads(at))
    throw std::domain_error(
        "wave: a rarefaction of this equation of state would steepen to a shock");
  return {WaveKind::rarefaction, isentrope_.start().sound_speed,
          at.sound_speed - at.velocity_change, flow_state(at)};
}

FlowState WaveCurve::inside(double speed) const {
  return flow_state(isentrope_.where(
      [speed](IsentropeState const& at) { return at.sound_speed - at.velocity_change - speed; }));
}

Wave in_frame(Wave wave, double velocity, bool mirror) {
  double const sign = mirror ? -1.0 : 1.0;
  wave.head = velocity + sign * wave.head;
  wave.tail = velocity + sign * wave.tail;
  wave.behind.velocity = velocity + sign * wave.behind.velocity;
  return wave;
}

}  // namespace moraine
