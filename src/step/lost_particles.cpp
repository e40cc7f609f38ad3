// Particles that leave the domain: counted, booked, removed.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "step/bad_particles.hpp"
#include "step/simulation.hpp"

namespace moraine {

void Simulation::remove_lost() {
  ParticleStore& store = model_.particles;
  std::size_t const count = store.range(Kind::fluid).size();
  auto const axes = static_cast<std::size_t>(model_.dimension);
  Components const position = components_of(store, Field::position);
  Components const velocity = components_of(store, Field::velocity);
  // The side that a particle is farthest beyond; `none` inside of the domain.
  auto const side_passed = [&](std::size_t i) {
    std::size_t side = none;
    double farthest = 0.0;
    for (std::size_t k = 0; k < axes; ++k) {
      if (model_.periodic[k]) continue;
      // Beyond a plane a particle changes places with its image.
      DomainSides const& sides = search_.settings().sides;
      double const below = sides.reflects(k, 0) ? 0.0 : model_.domain_min[k] - position[k][i];
      double const above = sides.reflects(k, 1) ? 0.0 : position[k][i] - model_.domain_max[k];
      if (std::max(below, above) <= farthest) continue;
      farthest = std::max(below, above);
      side = 2 * k + (above > below ? 1 : 0);
    }
    return side;
  };
  auto const add = [&](std::size_t begin, std::size_t end) {
    LostThroughSides lost{};
    for (std::size_t i = begin; i < end; ++i) {
      std::size_t const side = side_passed(i);
      if (side == none) continue;
      // Velocities are those of the half step, places those of its end. Gravity alone still acts on
      // who has left: its second half is done here, so that the sum of energies closes.
      double specific = store.scalar(Field::specific_energy)[i];
      for (std::size_t k = 0; k < axes; ++k) {
        double const v = velocity[k][i] + predict_by() * model_.gravity[k];
        specific += 0.5 * v * v - model_.gravity[k] * position[k][i];
      }
      double const mass = store.scalar(Field::mass)[i];
      lost[side].add({1, mass, mass * specific});
    }
    return lost;
  };
  auto const combine = [](LostThroughSides a, LostThroughSides const& b) {
    for (std::size_t side = 0; side < a.size(); ++side) a[side].add(b[side]);
    return a;
  };
  auto const nowhere = [&](std::size_t i) {
    for (std::size_t k = 0; k < axes; ++k)
      if (!std::isfinite(position[k][i])) return true;
    return false;
  };
  if (first_bad(count, nowhere) != none)
    fail({Guard::finite, all_bad(count, nowhere),
          [](std::size_t) { return "its position is not a finite number"; }});
  LostThroughSides const lost = reduce_blocks(count, LostThroughSides{}, add, combine);
  if (std::none_of(lost.begin(), lost.end(), [](auto const& side) { return side.count > 0; }))
    return;
  lost_ = combine(lost_, lost);
  leaving_.clear();
  for (std::size_t i = 0; i < count; ++i)
    if (side_passed(i) != none) leaving_.push_back(static_cast<std::uint32_t>(i));
  store.remove(leaving_);
  if (store.range(Kind::fluid).size() == 0)
    throw SimulationError(
        fmt::format("all particles have left the domain; time {:.6g} s, step {}", time_, step_));
}

}  // namespace moraine
