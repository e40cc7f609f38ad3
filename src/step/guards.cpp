#include "step/guards.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "smoothing/kernel_names.hpp"
#include "step/bad_particles.hpp"
#include "step/booked_energy.hpp"
#include "step/guard_findings.hpp"
#include "step/simulation.hpp"
#include "step/wall_guard.hpp"

namespace moraine {
namespace {

/// Part of a bound; nothing is found where there is no bound.
double part_of(double value, double bound) { return bound > 0.0 ? value / bound : 0.0; }

/// The larger one; what is no number stays.
void grow(double& part, double other) {
  if (std::isnan(part) || other <= part) return;
  part = other;
}

bool optional_and_on(GuardSettings const& settings, Guard guard) {
  return info(guard).optional && settings.looks(guard);
}

/// Whether a step is as short as it is because of the state, not by a setting.
bool asked_by_the_state(Vote const& vote) {
  return vote.reason == sound_limit || vote.reason == acceleration_limit ||
         vote.reason == motion_limit;
}

struct Extremes {
  double density = 0.0;             // part of its bound
  double speed2 = 0.0;              // m^2/s^2
  double above = 0.0, below = 0.0;  // J/kg, how far energies are out of the range of the start
};

Extremes extremes_of(Model const& model, GuardBounds const& bounds, StateRange const& start) {
  ParticleStore const& store = model.particles;
  auto const density = store.scalar(Field::density);
  auto const energy = store.scalar(Field::specific_energy);
  Components const velocity = components_of(store, Field::velocity);
  auto const in_block = [&](std::size_t begin, std::size_t end) {
    Extremes most;
    for (std::size_t i = begin; i < end; ++i) {
      std::size_t const m = store.material()[i];
      grow(most.density, part_of(density[i], bounds.density_max[m]));
      grow(most.density, part_of(bounds.density_min[m], density[i]));
      grow(most.speed2, square_of(velocity, i));
      grow(most.above, energy[i] - start.energy_max);
      grow(most.below, start.energy_min - energy[i]);
    }
    return most;
  };
  auto const combine = [](Extremes a, Extremes const& b) {
    grow(a.density, b.density);
    grow(a.speed2, b.speed2);
    grow(a.above, b.above);
    grow(a.below, b.below);
    return a;
  };
  return reduce_blocks(store.range(Kind::fluid).size(), Extremes{}, in_block, combine);
}

/// How far a particle may go between two looks at walls [m]: where there are n layers, it is found
/// at least between 0.8 and n - 0.8 spacings behind a face.
double longest_way(Numerics const& numerics) {
  double const layers =
      std::ceil(kernel_support * numerics.largest_smoothing_length() / numerics.spacing - 1e-9);
  return std::max(1.0, layers - 2.0) * numerics.spacing;
}

std::size_t at(Guard guard) { return static_cast<std::size_t>(guard); }

}  // namespace

bool GuardSettings::looks(Guard guard) const {
  return std::find(off.begin(), off.end(), info(guard).name) == off.end();
}

void Guards::begin(Simulation const& simulation) {
  start_.include(simulation.model());
  bounds_ = bounds_of(simulation.model(), start_);
  if (begun_++ == 0)
    start_energy_ = energy_balance(simulation.sums(), simulation.lost(), simulation.booked());
  motion_ = std::numeric_limits<double>::infinity();
  short_steps_ = 0;
}

void Guards::watch(Simulation const& simulation, double fastest) {
  Model const& model = simulation.model();
  double const way = simulation.time_step() * fastest;  // in this step, and about in the next
  motion_ += way;
  count_short_steps(simulation);
  Parts parts{};
  if (simulation.step() % static_cast<std::uint64_t>(model.guards.interval) == 0) {
    parts = measure(simulation);
    if (optional_and_on(model.guards, Guard::budget)) {
      Energy const energy = energy_of(simulation);
      energy_scale_ = energy.scale;
      parts[at(Guard::budget)] = part_in_budget(model, energy);
    }
  }
  if (!(motion_ + way < longest_way(model.numerics)) &&
      optional_and_on(model.guards, Guard::walls)) {
    parts[at(Guard::walls)] = part_in_walls(simulation);
    motion_ = 0.0;
  }
  for (std::size_t k = 0; k < guard_count; ++k) grow(parts_[k], parts[k]);
  stop_where_due(simulation, parts);
}

void Guards::look(Simulation const& simulation) const {
  Model const& model = simulation.model();
  Parts parts = measure(simulation);
  if (optional_and_on(model.guards, Guard::budget))
    parts[at(Guard::budget)] = part_in_budget(model, energy_of(simulation));
  if (optional_and_on(model.guards, Guard::walls))
    parts[at(Guard::walls)] = part_in_walls(simulation);
  stop_where_due(simulation, parts);
}

/// Parts of the bounds of single particles.
Guards::Parts Guards::measure(Simulation const& simulation) const {
  GuardSettings const& settings = simulation.model().guards;
  Parts parts{};
  auto const on = [&](Guard guard) { return optional_and_on(settings, guard); };
  if (!on(Guard::density) && !on(Guard::speed) && !on(Guard::energy)) return parts;
  Extremes const most = extremes_of(simulation.model(), bounds_, start_);
  if (on(Guard::density)) parts[at(Guard::density)] = most.density;
  if (on(Guard::speed)) parts[at(Guard::speed)] = part_of(std::sqrt(most.speed2), bounds_.speed);
  double& energy = parts[at(Guard::energy)];
  if (!on(Guard::energy)) return parts;
  grow(energy, part_of(most.above, bounds_.energy_max - start_.energy_max));
  grow(energy, part_of(most.below, start_.energy_min - bounds_.energy_min));
  return parts;
}

double Guards::part_in_walls(Simulation const& simulation) const {
  Model const& model = simulation.model();
  double const bound = bounds_.wall_depth;
  return part_of(deepest_in_walls({model.particles, simulation.search(), model.walls}, bound),
                 bound);
}

/// How far the total energy is off what is booked, and the energy that the run has to lose or to
/// gain, the largest so far: kinetic, internal, potential above the lowest particle of the start.
Guards::Energy Guards::energy_of(Simulation const& simulation) const {
  ConservedSums const sums = simulation.sums();
  double const potential = sums.potential_energy - sums.mass * start_.lowest_potential;
  double const scale =
      sums.kinetic_energy + std::fabs(sums.internal_energy) + std::max(potential, 0.0);
  return {energy_balance(sums, simulation.lost(), simulation.booked()) - start_energy_,
          std::max(energy_scale_, scale)};
}

double Guards::part_in_budget(Model const& model, Energy const& energy) const {
  if (!has_budget(model)) return 0.0;
  return part_of(std::fabs(energy.error), model.guards.energy_budget * energy.scale);
}

/// One short step is a meeting of two particles; a run that makes nothing else gets nowhere.
void Guards::count_short_steps(Simulation const& simulation) {
  GuardSettings const& settings = simulation.model().guards;
  if (!optional_and_on(settings, Guard::collapse)) return;
  Vote const& vote = simulation.vote();
  if (!asked_by_the_state(vote)) {
    short_steps_ = 0;
    return;
  }
  double const part = part_of(bounds_.time_step, vote.time_step);
  short_steps_ = part > 1.0 ? short_steps_ + 1 : 0;
  grow(parts_[at(Guard::collapse)], std::min(part, 1.0));
  if (short_steps_ < static_cast<std::uint64_t>(settings.interval)) return;
  Parts parts{};
  parts[at(Guard::collapse)] = part;
  stop_where_due(simulation, parts);
}

void Guards::stop_where_due(Simulation const& simulation, Parts const& parts) const {
  bool const good = std::all_of(parts.begin(), parts.end(), [](double p) { return p <= 1.0; });
  if (good) return;
  Energy const energy = energy_of(simulation);
  GuardContext const context{simulation, bounds_, start_, energy.error, energy.scale, short_steps_};
  std::vector<Finding> findings;
  for (GuardInfo const& guard : guard_table)
    if (!(parts[at(guard.guard)] <= 1.0)) findings.push_back(finding_of(guard.guard, context));
  throw error_of(
      {simulation.model(), simulation.time(), simulation.step(), simulation.vote(), votes_},
      std::move(findings));
}

void Guards::exchange(Archive& archive, Model const& model) {
  start_.exchange(archive);
  votes_.exchange(archive);
  archive.number("guards/start_energy", start_energy_);
  archive.number("guards/energy_scale", energy_scale_);
  archive.number("guards/motion", motion_);
  archive.number("guards/short_steps", short_steps_);
  archive.number("guards/begun", begun_);
  std::vector<double> parts(parts_.begin(), parts_.end());
  archive.array("guards/largest_parts", "", parts);
  if (!archive.restoring()) return;
  if (parts.size() != parts_.size() || start_.density_min.size() != model.materials.size() ||
      start_.density_max.size() != model.materials.size())
    throw std::runtime_error("guards and case do not belong together");
  std::copy(parts.begin(), parts.end(), parts_.begin());
  bounds_ = bounds_of(model, start_);
}

}  // namespace moraine
