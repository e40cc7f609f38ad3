#include "step/guard_findings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "step/bad_particles.hpp"
#include "step/simulation.hpp"
#include "step/wall_guard.hpp"

namespace moraine {
namespace {

std::size_t count_of(Simulation const& simulation) {
  return simulation.particles().range(Kind::fluid).size();
}

/// All particles whose badness is above 1, or no number.
template <class Badness>
std::vector<Suspect> worse_than_bound(Simulation const& simulation, Badness&& badness) {
  std::vector<Suspect> suspects;
  for (std::size_t i = 0; i < count_of(simulation); ++i) {
    double const part = badness(i);
    if (!(part <= 1.0)) suspects.push_back({i, part});
  }
  return suspects;
}

Finding density_finding(GuardContext const& at) {
  ParticleStore const& store = at.simulation.particles();
  auto const density = store.scalar(Field::density);
  auto const bounds = [&at, &store](std::size_t i) {
    std::size_t const m = store.material()[i];
    return std::pair(at.bounds.density_min[m], at.bounds.density_max[m]);
  };
  auto const badness = [&](std::size_t i) {
    return std::max(density[i] / bounds(i).second, bounds(i).first / density[i]);
  };
  auto const cause = [density, bounds](std::size_t i) {
    auto const [low, high] = bounds(i);
    bool const thin = density[i] < low;
    return fmt::format("its density {:.6g} kg/m^3 is {} {:.6g} kg/m^3 (guards.{})", density[i],
                       thin ? "below" : "above", thin ? low : high,
                       thin ? "expansion" : "compression");
  };
  return {Guard::density, worse_than_bound(at.simulation, badness), cause};
}

Finding speed_finding(GuardContext const& at) {
  Components const velocity = components_of(at.simulation.particles(), Field::velocity);
  double const bound = at.bounds.speed;
  auto const speed = [velocity](std::size_t i) { return std::sqrt(square_of(velocity, i)); };
  return {Guard::speed,
          worse_than_bound(at.simulation, [&](std::size_t i) { return speed(i) / bound; }),
          [speed, bound](std::size_t i) {
            return fmt::format("its speed {:.4g} m/s is above {:.4g} m/s (guards.speed)", speed(i),
                               bound);
          }};
}

Finding energy_finding(GuardContext const& at) {
  auto const energy = at.simulation.particles().scalar(Field::specific_energy);
  auto const [low, high] = std::pair(at.bounds.energy_min, at.bounds.energy_max);
  StateRange const& start = at.start;
  auto const badness = [&, low = low, high = high](std::size_t i) {
    return std::max((energy[i] - start.energy_max) / (high - start.energy_max),
                    (start.energy_min - energy[i]) / (start.energy_min - low));
  };
  auto const cause = [energy, low = low, high = high](std::size_t i) {
    bool const cold = energy[i] < low;
    return fmt::format("its specific energy {:.4g} J/kg is {} {:.4g} J/kg (guards.specific_energy)",
                       energy[i], cold ? "below" : "above", cold ? low : high);
  };
  return {Guard::energy, worse_than_bound(at.simulation, badness), cause};
}

Finding wall_finding(GuardContext const& at) {
  Model const& model = at.simulation.model();
  double const bound = at.bounds.wall_depth;
  auto suspects = deeper_in_walls({model.particles, at.simulation.search(), model.walls}, bound);
  std::map<std::size_t, double> depth;
  for (Suspect const& suspect : suspects) depth[suspect.particle] = suspect.badness;
  return {Guard::walls, std::move(suspects), [depth, bound](std::size_t i) {
            return fmt::format(
                "it is inside a wall, {:.3g} m or more behind the face, deeper than {:.3g} m "
                "(guards.wall_depth)",
                depth.at(i), bound);
          }};
}

Finding budget_finding(GuardContext const& at) {
  ParticleStore const& store = at.simulation.particles();
  auto const energy = store.scalar(Field::specific_energy);
  Components const velocity = components_of(store, Field::velocity);
  double const at_start = at.start.energy_max;
  auto const own = [energy, velocity, at_start](std::size_t i) {
    return 0.5 * square_of(velocity, i) + std::max(energy[i] - at_start, 0.0);
  };
  Suspect most;
  for (std::size_t i = 0; i < count_of(at.simulation); ++i)
    if (!(own(i) <= most.badness)) most = {i, own(i)};
  auto const cause = [own, error = at.energy_error, scale = at.energy_scale,
                      bound = at.simulation.model().guards.energy_budget](std::size_t i) {
    return fmt::format(
        "the energy of all particles has changed by {:.4g} J that nothing accounts for, more than "
        "{:.3g} of the {:.4g} J of the run (guards.energy_budget); this particle has the most, "
        "{:.4g} J/kg",
        error, bound, scale, own(i));
  };
  return {Guard::budget, {most}, cause};
}

Finding collapse_finding(GuardContext const& at) {
  auto const id = at.simulation.particles().id();
  std::uint64_t const who = at.simulation.vote().particle;
  auto const found = std::find(id.begin(), id.end(), who);
  std::vector<Suspect> suspects;
  if (found != id.end()) suspects.push_back({static_cast<std::size_t>(found - id.begin()), 0.0});
  return {Guard::collapse, std::move(suspects),
          [steps = at.short_steps, bound = at.bounds.time_step](std::size_t) {
            return fmt::format(
                "for {} steps the time step has been below {:.3g} s (guards.time_step)", steps,
                bound);
          }};
}

}  // namespace

bool has_budget(Model const& model) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(model.dimension); ++k)
    if (model.periodic[k] && model.gravity[k] != 0.0) return false;
  return true;
}

Finding finding_of(Guard guard, GuardContext const& context) {
  switch (guard) {
    case Guard::density:
      return density_finding(context);
    case Guard::speed:
      return speed_finding(context);
    case Guard::energy:
      return energy_finding(context);
    case Guard::walls:
      return wall_finding(context);
    case Guard::budget:
      return budget_finding(context);
    default:
      return collapse_finding(context);
  }
}

}  // namespace moraine
