// Walls that move as prescribed.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/parallel_for.hpp"
#include "step/simulation.hpp"
#include "step/simulation_error.hpp"

namespace moraine {

/// A wall may neither pass the fluid within a step nor be accelerated so that the step misses it.
Vote Simulation::vote_of_walls() const {
  double const h = model_.numerics.least_smoothing_length();
  Vote vote;
  for (std::size_t w = 0; w < model_.walls.bodies.size(); ++w) {
    if (wall_is_present_[w] == 0) continue;
    MovingWall const& wall = model_.walls.bodies[w];
    double const speed = wall.state.largest_speed(wall.radius);
    double const acceleration = wall.state.largest_acceleration(wall.radius);
    vote = stricter(vote, {longest_motion * h / speed, wall_motion_limit, Vote::nobody});
    vote = stricter(vote, {model_.time.courant * std::sqrt(h / acceleration),
                           wall_acceleration_limit, Vote::nobody});
  }
  return vote;
}

/// The largest frequency of a particle in the field of the wall, omega^2 = k/m, must be resolved:
/// omega dt <= C / 2. 2 is the limit of leapfrog, whose energy swings by (omega dt)^2 / 4, 0.6 %
/// with C = 0.3; what is left of that when a particle has turned round adds up where the force
/// begins with a kink and steps vary.
Vote Simulation::vote_of_repulsion() const {
  if (pushed_.stiffness == 0.0) return {};
  return {0.5 * model_.time.courant / std::sqrt(pushed_.stiffness), repulsion_limit,
          model_.particles.id()[pushed_.particle]};
}

/// No wall is faster [m/s].
double Simulation::speed_of_walls() const {
  double fastest = 0.0;
  for (std::size_t w = 0; w < model_.walls.bodies.size(); ++w) {
    MovingWall const& wall = model_.walls.bodies[w];
    if (wall_is_present_[w] != 0)
      fastest = std::max(fastest, wall.state.largest_speed(wall.radius));
  }
  return fastest;
}

void Simulation::move_walls() {
  WallData& walls = model_.walls;
  if (!walls.move()) return;
  for (MovingWall& wall : walls.bodies) wall.state = wall.motion.at(time_ + vote_.time_step);
  ParticleStore& store = model_.particles;
  Range const range = store.range(Kind::wall);
  DomainSides const& sides = search_.settings().sides;
  for_each_block(range.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = range.begin + begin; k < range.begin + end; ++k) {
      std::size_t const number = store.id()[k] - walls.first_id;
      WallPoint const& point = walls.points[number];
      if (point.body == WallPoint::at_rest) continue;
      Vec3 const place = walls.bodies[point.body].state.place(walls.start[number]);
      for (int axis = 0; axis < model_.dimension; ++axis) {
        auto const a = static_cast<std::size_t>(axis);
        double& x = store.component(Field::position, axis)[k];
        // Of the places that are whole periods apart the one next to the last.
        double const periods =
            sides.periodic[a] ? std::round((x - place[a]) / sides.length[a]) : 0.0;
        x = place[a] + periods * sides.length[a];
      }
    }
  });
  check_places_of_walls();
}

void Simulation::find_present_walls() {
  WallData const& walls = model_.walls;
  wall_is_present_.assign(walls.bodies.size(), 0);
  if (!walls.move()) return;
  for (WallFace const& face : walls.faces)  // these stay to the end
    if (face.body != WallFace::at_rest) wall_is_present_[face.body] = 1;
  Range const range = model_.particles.range(Kind::wall);
  for (std::uint64_t const id : model_.particles.id().subspan(range.begin, range.size())) {
    std::uint16_t const body = walls.points[id - walls.first_id].body;
    if (body != WallPoint::at_rest) wall_is_present_[body] = 1;
  }
}

/// Beyond its box the search knows no places.
void Simulation::check_places_of_walls() const {
  ParticleStore const& store = model_.particles;
  Range const range = store.range(Kind::wall);
  double const margin =
      2.0 * kernel_support * model_.numerics.largest_smoothing_length();  // as search_settings
  for (int axis = 0; axis < model_.dimension; ++axis) {
    auto const a = static_cast<std::size_t>(axis);
    auto const x = store.component(Field::position, axis);
    for (std::size_t k = range.begin; k < range.begin + range.size(); ++k) {
      if (x[k] >= model_.domain_min[a] - margin && x[k] <= model_.domain_max[a] + margin) continue;
      throw SimulationError(
          fmt::format("a moving wall leaves the domain: one of its particles is at {} = {:.6g} m; "
                      "time {:.6g} s, step {}; enlarge the domain",
                      "xyz"[axis], x[k], time_ + vote_.time_step, step_));
    }
  }
}

}  // namespace moraine
