#include "step/simulation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "step/simulation_setup.hpp"

namespace moraine {
namespace {

constexpr std::array action_table{
    Simulation::ActionInfo{"stage", "when a stage is over, begin the next and what it changes"},
    Simulation::ActionInfo{"time step", "every limit votes; the shortest step wins"},
    Simulation::ActionInfo{"kick and drift",
                           "half a step of velocity, density and energy; a whole "
                           "step of position; smoothing lengths that vary"},
    Simulation::ActionInfo{"move walls", "put walls that move to their new places"},
    Simulation::ActionInfo{"search",
                           "check the neighbour lists; when worn out remove particles that left "
                           "the domain, re-sort and rebuild"},
    Simulation::ActionInfo{"density", "where it is no state: sum it over neighbours"},
    Simulation::ActionInfo{"matter", "pressure and sound speed from the equations of state"},
    Simulation::ActionInfo{"stress", "predict the stress of solids, and let it yield"},
    Simulation::ActionInfo{"gather", "copy what pair terms read into records; refresh images"},
    Simulation::ActionInfo{"walls", "continue pressure and density into wall particles"},
    Simulation::ActionInfo{"pairs", "sum all pair terms: rates of velocity, density and energy"},
    Simulation::ActionInfo{"optional terms",
                           "physical viscosity, averaging, shifting, corrected gradients, penalty "
                           "between materials, where the case asks for them"},
    Simulation::ActionInfo{"strength", "solids: gradient of velocity, divergence of stress"},
    Simulation::ActionInfo{"kick and check",
                           "gravity, second half of the step, guard against what is no number"},
    Simulation::ActionInfo{"absorb", "absorbing layers: let velocity and stress fade"},
    Simulation::ActionInfo{"guards",
                           "every few steps: density, speed, energy, walls, energy budget; short "
                           "steps in a row"},
};

}  // namespace

std::span<Simulation::ActionInfo const> Simulation::actions() { return action_table; }

Simulation::Simulation(Model model, Unstarted)
    : model_(std::move(model)),
      search_(search_settings(model_)),
      pairs_(make_pair_backend(model_.dimension, model_.flavour(), scheme_of(model_),
                               sweep_parameters(model_), reference_densities(model_))),
      options_(make_options_of(model_)),
      strength_(make_strength_of(model_)),
      stages_(std::move(model_.stages)) {
  option_parameters_ = option_parameters(model_);
  if (option_parameters_.moves_places()) model_.particles.use(Field::drift);
  if (strength_)
    for (Field const field : solid_fields) model_.particles.use(field);
  using Run = void (Simulation::*)();
  constexpr std::array<Run, action_table.size()> runs{
      &Simulation::change_stage,    &Simulation::choose_time_step,
      &Simulation::kick_and_drift,  &Simulation::move_walls,
      &Simulation::find_neighbours, &Simulation::sum_densities,
      &Simulation::evaluate_matter, &Simulation::predict_stress,
      &Simulation::gather,          &Simulation::continue_into_walls,
      &Simulation::sum_pairs,       &Simulation::sum_optional_terms,
      &Simulation::sum_strength,    &Simulation::kick_and_check,
      &Simulation::absorb,          &Simulation::watch};
  for (std::size_t k = 0; k < runs.size(); ++k)
    sequence_.push_back({action_table[k], runs[k], timers_.add(action_table[k].label)});
  model_.particles.shrink();
  find_present_walls();
}

Simulation::Simulation(Model model) : Simulation(std::move(model), Unstarted{}) {
  begin_smoothing();
  light_explosives();
  stages_.begin_first();
  begin_stage();
  evaluate_rates();
}

Simulation::Simulation(Model model, Archive& saved) : Simulation(std::move(model), Unstarted{}) {
  exchange(saved);
  acceleration_vote_.reason = acceleration_limit;
  motion_vote_.reason = motion_limit;
  sort_by_material();
  for (MovingWall& wall : model_.walls.bodies) wall.state = wall.motion.at(time_);
  find_present_walls();
  half_step_factor_ = 1.0;
}

void Simulation::save(Archive& archive) { exchange(archive); }

void Simulation::exchange(Archive& archive) {
  archive.number("time", time_);
  archive.number("step", step_);
  booked_.exchange(archive);
  archive.number("booked_energy/damping_power", damping_power_);
  guards_.exchange(archive, model_);
  stages_.exchange(archive);
  archive.number("time_step/last", vote_.time_step);
  archive.number("time_step/acceleration_limit", acceleration_vote_.time_step);
  archive.number("time_step/motion_limit", motion_vote_.time_step);
  archive.number("time_step/signal_speed", swept_.signal_speed);
  archive.number("time_step/acceleration_particle", acceleration_vote_.particle);
  archive.number("time_step/motion_particle", motion_vote_.particle);
  std::uint64_t fastest = swept_.particle;
  archive.number("time_step/signal_particle", fastest);
  swept_.particle = fastest;
  for (std::size_t side = 0; side < lost_.size(); ++side) {
    std::string const name = fmt::format("lost/{}{}", "xyz"[side / 2], "-+"[side % 2]);
    archive.number(name + "/count", lost_[side].count);
    archive.number(name + "/mass", lost_[side].mass);
    archive.number(name + "/energy", lost_[side].energy);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    archive.number(fmt::format("wall_impulse_{}", "xyz"[axis]), wall_impulse_[axis]);
  for (std::size_t axis = 0; axis < 3; ++axis)
    archive.number(fmt::format("wall_force_{}", "xyz"[axis]), swept_.wall_force[axis]);
  archive.number("wall_power", swept_.wall_power);
  if (options_) exchange_options(archive);
  archive.number("walls/repulsion_energy", pushed_.energy);
  archive.number("walls/repulsion_stiffness", pushed_.stiffness);
  std::uint64_t pushed = pushed_.particle;
  archive.number("walls/repulsed_particle", pushed);
  pushed_.particle = pushed;
  archive.number("smoothing/clipped_at_least", smoothing_clips_.at_least);
  archive.number("smoothing/clipped_at_most", smoothing_clips_.at_most);
  model_.particles.exchange(archive);
  for (Material const& material : model_.materials)
    if (can_compact(material.eos) && !model_.particles.has(Field::distension))
      throw std::runtime_error(
          fmt::format("{} has pores, but the particles have no distension", material.name));
  for (Material const& material : model_.materials)
    for (Field const field : {Field::burn_fraction, Field::lighting_time})
      if (material.burn && !model_.particles.has(field))
        throw std::runtime_error(
            fmt::format("{} burns, but the particles have no {}", material.name, info(field).name));
  if (archive.restoring() &&
      model_.particles.has(Field::smoothing_length) != model_.numerics.smoothing.varies())
    throw std::runtime_error("smoothing lengths and case do not belong together");
  search_.exchange(archive, model_.particles);
}

void Simulation::run_actions(std::size_t first) {
  for (std::size_t k = first; k < sequence_.size(); ++k) {
    ScopedTimer const timing(timers_, sequence_[k].timer);
    (this->*sequence_[k].run)();
  }
}

/// Rates of the present state: the second half of a step, with a step length of zero.
void Simulation::evaluate_rates() {
  vote_.time_step = 0.0;
  half_step_factor_ = 0.0;
  run_actions(3);
  half_step_factor_ = 1.0;
}

void Simulation::advance() {
  run_actions(0);
  ++step_;
  time_ = vote_.reason == end_of_run ? model_.time.end : time_ + vote_.time_step;
}

void Simulation::find_neighbours() {
  if (search_.settings().sides.any_wall()) {
    Vec3 const before = search_.reflections().impulse;
    search_.return_from_walls(model_.particles);
    wall_impulse_ = add(wall_impulse_, subtract(search_.reflections().impulse, before));
  }
  if (search_.lists_hold(model_.particles)) return;
  remove_lost();
  search_.rebuild(model_.particles);
  sort_by_material();
}

void Simulation::gather() { pairs_->gather_fluid(model_.particles, search_, predict_by()); }

void Simulation::continue_into_walls() {
  pairs_->gather_walls(model_.particles, search_, model_.walls);
  if (options_ && option_parameters_.any())
    options_->gather(model_.particles, search_, model_.walls, predict_by());
  if (strength_) strength_->gather(model_.particles, search_, model_.walls, predict_by());
}

LostParticles Simulation::lost() const {
  LostParticles all;
  for (LostParticles const& side : lost_) all.add(side);
  return all;
}

void Simulation::sum_pairs() {
  book_walls();  // as momentum and energy are integrated: half a step with the old rates
  swept_ = pairs_->sweep(model_.particles, search_);
  if (!model_.walls.push()) return;
  // No step is longer than that of the sound, unless it is fixed.
  double const longest = model_.time.courant * model_.numerics.smoothing_length();
  pushed_ = push_from_faces(model_.particles, model_.walls, longest / swept_.signal_speed);
  swept_.wall_force = add(swept_.wall_force, pushed_.force);
  swept_.wall_power += pushed_.power;
}

/// Half a step of what walls do to the fluid at the present rates.
void Simulation::book_walls() {
  double const half = 0.5 * vote_.time_step;
  booked_.walls += half * swept_.wall_power;
  for (std::size_t axis = 0; axis < 3; ++axis)
    wall_impulse_[axis] += half * swept_.wall_force[axis];
}

std::size_t Simulation::bytes() const {
  std::size_t sum = model_.particles.bytes() + search_.bytes() + pairs_->bytes() +
                    (options_ ? options_->bytes() : 0) + (strength_ ? strength_->bytes() : 0) +
                    model_.walls.points.capacity() * sizeof(WallPoint) +
                    leaving_.capacity() * sizeof(std::uint32_t);
  for (auto const& indices : by_material_) sum += indices.capacity() * sizeof(std::uint32_t);
  return sum;
}

}  // namespace moraine
