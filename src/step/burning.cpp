// Programmed burn: when particles are lit, and what that asks of the time step.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"
#include "step/bad_particles.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Distance of a place to the nearest ignition, or to its image across periodic sides [m].
double way_of_front(Model const& model, Ignition const& ignition, Ignition::Place const& place) {
  double least = never;
  std::array<int, 3> images{};
  for (std::size_t axis = 0; axis < 3; ++axis) images[axis] = model.periodic[axis] ? 1 : 0;
  for (int x = -images[0]; x <= images[0]; ++x)
    for (int y = -images[1]; y <= images[1]; ++y)
      for (int z = -images[2]; z <= images[2]; ++z) {
        Ignition::Place image = place;
        for (std::size_t axis = 0; axis < 3; ++axis)
          image[axis] +=
              std::array{x, y, z}[axis] * (model.domain_max[axis] - model.domain_min[axis]);
        least = std::min(least, ignition.distance(image));
      }
  return least;
}

}  // namespace

/// Lights a particle of an explosive that burns, as of now.
void Simulation::light(std::size_t particle) {
  ParticleStore& store = model_.particles;
  Burn const& burn = *model_.materials[store.material()[particle]].burn;
  Ignition::Place place{};
  for (int axis = 0; axis < model_.dimension; ++axis)
    place[static_cast<std::size_t>(axis)] = store.component(Field::position, axis)[particle];
  store.scalar(Field::lighting_time)[particle] =
      time_ + burn.ignition.delay +
      way_of_front(model_, burn.ignition, place) / burn.law.detonation_velocity;
}

/// At the start all explosives are lit but those that a later stage detonates.
void Simulation::light_explosives() {
  ParticleStore& store = model_.particles;
  if (!store.has(Field::lighting_time)) return;
  auto lighting_time = store.scalar(Field::lighting_time);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (model_.materials[store.material()[i]].burn && lighting_time[i] == never) light(i);
  auto const& stages = stages_.all();
  for (std::size_t k = 1; k < stages.size(); ++k)
    for (Transformation const& change : stages[k].transformations)
      for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
        if (std::binary_search(change.ids.begin(), change.ids.end(), store.id()[i]))
          lighting_time[i] = never;
}

/// While explosive is left, whether lit or not: no step in which the front, of speed D, goes
/// farther than sound of that speed may. Sound speeds know of the front only where it is already,
/// and explosive that burns by compression has none before.
Vote Simulation::vote_of_burn() const {
  Vote vote;
  ParticleStore const& store = model_.particles;
  if (!store.has(Field::burn_fraction)) return vote;
  auto const fraction = store.scalar(Field::burn_fraction);
  auto const lighting_time = store.scalar(Field::lighting_time);
  double const h = model_.numerics.least_smoothing_length();
  auto const sooner = [&](std::size_t a, std::size_t b) {
    if (a == none || b == none) return std::min(a, b);
    return lighting_time[b] < lighting_time[a] ? b : a;
  };
  for (std::size_t m = 0; m < model_.materials.size(); ++m) {
    auto const& burn = model_.materials[m].burn;
    if (!burn) continue;
    auto const next_in = [&](std::size_t begin, std::size_t end) {
      std::size_t next = none;
      for (std::size_t i = begin; i < end; ++i)
        if (store.material()[i] == m && fraction[i] < 1.0) next = sooner(next, i);
      return next;
    };
    std::size_t const next = reduce_blocks(store.range(Kind::fluid).size(), none, next_in, sooner);
    if (next != none)
      vote = stricter(vote, {model_.time.courant * h / burn->law.detonation_velocity, burn_limit,
                             store.id()[next]});
  }
  return vote;
}

}  // namespace moraine
