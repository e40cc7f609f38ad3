#include "sloshing/tank_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "records/oscillator.hpp"

namespace moraine {
namespace {

/// Liquid that moves with the tank as a whole.
void add_rigid_part(RigidTank const& tank, TankResponse& response) {
  double const d = tank.depth, m = tank.mass();
  double const turning = m * (0.5 * d + tank.length * tank.length / (12.0 * d));
  for (std::size_t i = 0; i < response.ground.size(); ++i) {
    double const a = response.ground.acceleration[i];
    response.force[i] -= m * a;
    response.wall_moment[i] -= 0.5 * m * d * a;
    response.turning_moment[i] -= turning * a;
  }
}

void add_mode(RigidTank const& tank, int n, double damping, TankResponse& response) {
  SloshingMode const mode = sloshing_mode(tank, n);
  double const w = mode.angular_frequency;
  double const amplitude =
      4.0 * tank.length / (std::numbers::pi * std::numbers::pi * n * n) * w * w / tank.gravity;
  Oscillator const oscillator(w, damping, response.ground.time_step);
  OscillatorState state;
  std::vector<double> const& a = response.ground.acceleration;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i > 0) state = oscillator.advance(state, a[i - 1], a[i]);
    double const reaction = mode.mass * oscillator.relative_acceleration(state, a[i]);
    response.surface[i] += amplitude * state.displacement;
    response.force[i] -= reaction;
    response.wall_moment[i] -= mode.height.walls * reaction;
    response.turning_moment[i] -= mode.height.walls_and_floor * reaction;
  }
}

}  // namespace

TankResponse tank_response(RigidTank const& tank, GroundRecord const& record,
                           ResponseSettings const& settings) {
  check_tank(tank);
  check_record(record);
  if (settings.modes < 1 || settings.modes > 10000)
    throw std::invalid_argument("tank response: the number of modes must be 1 to 10000");
  double const free_steps = std::ceil(settings.free_time / record.time_step);
  if (!(free_steps >= 0.0 && free_steps < 1e7))
    throw std::invalid_argument("tank response: the free time must be positive, at most 1e7 steps");
  TankResponse response{record, {}, {}, {}, {}};
  response.ground.acceleration.resize(record.size() + static_cast<std::size_t>(free_steps), 0.0);
  for (auto* history :
       {&response.surface, &response.force, &response.wall_moment, &response.turning_moment})
    history->assign(response.ground.size(), 0.0);
  add_rigid_part(tank, response);
  for (int k = 0; k < settings.modes; ++k) add_mode(tank, 2 * k + 1, settings.damping, response);
  return response;
}

double Range::size() const { return std::max(std::fabs(largest), std::fabs(smallest)); }

Range range_of(GroundRecord const& ground, std::vector<double> const& history) {
  auto const high = std::max_element(history.begin(), history.end());
  auto const low = std::min_element(history.begin(), history.end());
  auto const time = [&](auto place) {
    return ground.time(static_cast<std::size_t>(place - history.begin()));
  };
  return {*high, time(high), *low, time(low)};
}

}  // namespace moraine
