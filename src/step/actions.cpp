// What the actions of a step do to the state of the particles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"
#include "step/simulation.hpp"
#include "step/simulation_error.hpp"
#include "step/simulation_setup.hpp"

namespace moraine {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Lowest index for which a particle is bad; `none` when all are good.
template <class Bad>
std::size_t first_bad(std::size_t count, Bad&& bad) {
  auto const in_block = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (bad(i)) return i;
    return none;
  };
  return reduce_blocks(count, none, in_block,
                       [](std::size_t a, std::size_t b) { return std::min(a, b); });
}

/// A largest value and where it is; the first that is not a number stays.
struct Largest {
  double value = 0.0;
  std::size_t particle = 0;

  void include(double other, std::size_t at) {
    if (std::isnan(value) || other <= value) return;
    value = other;
    particle = at;
  }
};

using Components = std::array<std::span<double const>, 3>;

Components components_of(ParticleStore const& store, Field field) {
  Components result;
  for (int axis = 0; axis < store.dimension(); ++axis)
    result[static_cast<std::size_t>(axis)] = store.component(field, axis);
  return result;
}

double square_of(Components const& vector, std::size_t i) {
  double sum = 0.0;
  for (auto const& component : vector)
    if (!component.empty()) sum += component[i] * component[i];
  return sum;
}

}  // namespace

void Simulation::choose_time_step() {
  TimeSpec const& spec = model_.time;
  double const h = model_.numerics.smoothing_length();
  Vote vote{spec.courant * h / swept_.signal_speed, "sound and viscosity",
            model_.particles.id()[swept_.particle]};
  vote = stricter(vote, acceleration_vote_);
  vote = stricter(vote, motion_vote_);
  vote = stricter(vote, vote_of_walls());
  if (stages_.damping() > 0.0)
    vote = stricter(vote, {0.5 / stages_.damping(), "damping", Vote::nobody});
  if (spec.fixed_step > 0.0) vote = {spec.fixed_step, "fixed step", Vote::nobody};
  vote = stricter(vote, {spec.max_step, "largest step", Vote::nobody});
  vote = stricter(vote, {spec.end - time_, end_of_run, Vote::nobody});
  vote_ = vote;
  if (!(time_ + vote.time_step > time_)) fail_to_advance();
}

void Simulation::kick_and_drift() {
  ParticleStore& store = model_.particles;
  std::size_t const count = store.range(Kind::fluid).size();
  double const dt = vote_.time_step;
  double const h = model_.numerics.smoothing_length();
  double const fastest2 = (h / dt) * (h / dt);
  Components const velocity = components_of(store, Field::velocity);
  auto const advance = [&](std::size_t begin, std::size_t end) {
    for (int axis = 0; axis < model_.dimension; ++axis) {
      auto x = store.component(Field::position, axis);
      auto v = store.component(Field::velocity, axis);
      auto const a = store.component(Field::acceleration, axis);
      for (std::size_t i = begin; i < end; ++i) {
        v[i] += 0.5 * dt * a[i];
        x[i] += dt * v[i];
      }
    }
    auto const half_kick = [&](Field field, Field rate_field) {
      auto value = store.scalar(field);
      auto const rate = store.scalar(rate_field);
      for (std::size_t i = begin; i < end; ++i) value[i] += 0.5 * dt * rate[i];
    };
    half_kick(Field::density, Field::density_rate);
    half_kick(Field::specific_energy, Field::energy_rate);
    for (std::size_t i = begin; i < end; ++i)
      if (!(square_of(velocity, i) <= fastest2)) return i;
    return none;
  };
  std::size_t const bad = reduce_blocks(
      count, none, advance, [](std::size_t a, std::size_t b) { return std::min(a, b); });
  if (bad != none)
    fail(bad,
         fmt::format("it moves {:.4g} m in one step, farther than the smoothing length {:.4g} m",
                     dt * std::sqrt(square_of(velocity, bad)), h));
}

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
      // Beyond a symmetry plane a particle has changed places with its image.
      auto const& plane = model_.symmetry.planes[k];
      double const below = plane[0] ? 0.0 : model_.domain_min[k] - position[k][i];
      double const above = plane[1] ? 0.0 : position[k][i] - model_.domain_max[k];
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
      double specific = store.scalar(Field::specific_energy)[i] + 0.5 * square_of(velocity, i);
      for (std::size_t k = 0; k < axes; ++k) specific -= model_.gravity[k] * position[k][i];
      double const mass = store.scalar(Field::mass)[i];
      lost[side].add({1, mass, mass * specific});
    }
    return lost;
  };
  auto const combine = [](LostThroughSides a, LostThroughSides const& b) {
    for (std::size_t side = 0; side < a.size(); ++side) a[side].add(b[side]);
    return a;
  };
  std::size_t const bad = first_bad(count, [&](std::size_t i) {
    for (std::size_t k = 0; k < axes; ++k)
      if (!std::isfinite(position[k][i])) return true;
    return false;
  });
  if (bad != none) fail(bad, "its position is not a finite number");
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

void Simulation::sort_by_material() {
  by_material_.resize(model_.materials.size());
  if (model_.materials.size() == 1) return;  // all of them, in order
  for (auto& indices : by_material_) indices.clear();
  Range const fluid = model_.particles.range(Kind::fluid);
  for (std::size_t i = fluid.begin; i < fluid.end; ++i)
    by_material_[model_.particles.material()[i]].push_back(static_cast<std::uint32_t>(i));
}

void Simulation::evaluate_matter() {
  ParticleStore& store = model_.particles;
  auto const density = store.scalar(Field::density);
  auto const density_rate = store.scalar(Field::density_rate);
  auto const energy = store.scalar(Field::specific_energy);
  auto const energy_rate = store.scalar(Field::energy_rate);
  auto pressure = store.scalar(Field::pressure);
  auto sound_speed = store.scalar(Field::sound_speed);
  double const ahead = predict_by();
  auto const pass = [&](auto const& law, std::size_t count, auto&& index) {
    for_each_block(count, loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        std::size_t const i = index(k);
        auto const state =
            law.respond(density[i] + ahead * density_rate[i], energy[i] + ahead * energy_rate[i]);
        pressure[i] = state.pressure;
        sound_speed[i] = state.sound_speed;
      }
    });
  };
  for (std::size_t m = 0; m < model_.materials.size(); ++m) {
    std::visit(
        [&](auto const& law) {
          if (model_.materials.size() == 1)
            pass(law, store.range(Kind::fluid).size(), [](std::size_t k) { return k; });
          else
            pass(law, by_material_[m].size(), [&](std::size_t k) { return by_material_[m][k]; });
        },
        model_.materials[m].eos);
  }
  std::size_t const count = store.range(Kind::fluid).size();
  std::size_t const bad = first_bad(count, [&](std::size_t i) { return !(sound_speed[i] >= 0.0); });
  if (bad != none)
    fail(bad,
         fmt::format("the equation of state gives no sound speed (c^2 < 0) at density {} kg/m^3, "
                     "specific energy {} J/kg",
                     density[bad], energy[bad]));
}

void Simulation::kick_and_check() {
  ParticleStore& store = model_.particles;
  std::size_t const count = store.range(Kind::fluid).size();
  double const half = predict_by();
  double const damping = stages_.damping();
  struct Outcome {
    Largest acceleration2, speed2;
    std::size_t bad = none;
  };
  auto density = store.scalar(Field::density);
  auto energy = store.scalar(Field::specific_energy);
  auto const density_rate = store.scalar(Field::density_rate);
  auto const energy_rate = store.scalar(Field::energy_rate);
  std::array<std::span<double>, 3> acceleration, velocity;
  for (int axis = 0; axis < model_.dimension; ++axis) {
    acceleration[static_cast<std::size_t>(axis)] = store.component(Field::acceleration, axis);
    velocity[static_cast<std::size_t>(axis)] = store.component(Field::velocity, axis);
  }
  auto const kick = [&](std::size_t begin, std::size_t end) {
    Outcome outcome;
    for (std::size_t i = begin; i < end; ++i) {
      density[i] += half * density_rate[i];
      energy[i] += half * energy_rate[i];
      double acceleration2 = 0.0;
      double velocity2 = 0.0;
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(model_.dimension); ++axis) {
        double& a = acceleration[axis][i];
        double& v = velocity[axis][i];
        a += model_.gravity[axis] - damping * v;
        v += half * a;
        acceleration2 += a * a;
        velocity2 += v * v;
      }
      outcome.acceleration2.include(acceleration2, i);
      outcome.speed2.include(velocity2, i);
      bool const good =
          std::isfinite(density[i] + energy[i] + velocity2 + acceleration2) && density[i] > 0.0;
      if (!good && outcome.bad == none) outcome.bad = i;
    }
    return outcome;
  };
  auto const combine = [](Outcome a, Outcome const& b) {
    a.acceleration2.include(b.acceleration2.value, b.acceleration2.particle);
    a.speed2.include(b.speed2.value, b.speed2.particle);
    a.bad = std::min(a.bad, b.bad);
    return a;
  };
  Outcome const outcome = reduce_blocks(count, Outcome{}, kick, combine);
  if (outcome.bad != none)
    fail(outcome.bad, density[outcome.bad] > 0.0
                          ? "its velocity, density, energy or acceleration is not a finite number"
                          : "its density is not positive");
  double const h = model_.numerics.smoothing_length();
  auto const id = store.id();
  acceleration_vote_ = {model_.time.courant * std::sqrt(h / std::sqrt(outcome.acceleration2.value)),
                        acceleration_limit, id[outcome.acceleration2.particle]};
  motion_vote_ = {longest_motion * h / std::sqrt(outcome.speed2.value), motion_limit,
                  id[outcome.speed2.particle]};
  for (std::size_t axis = 0; axis < 3; ++axis)
    wall_impulse_[axis] += swept_.wall_force[axis] * vote_.time_step;
}

void Simulation::fail(std::size_t particle, std::string const& cause) const {
  ParticleStore const& store = model_.particles;
  std::string place;
  for (int axis = 0; axis < model_.dimension; ++axis)
    place += fmt::format("{}{:.6g}", axis == 0 ? "" : ", ",
                         store.component(Field::position, axis)[particle]);
  std::string const who =
      vote_.particle == Vote::nobody ? "" : fmt::format(" of particle {}", vote_.particle);
  throw SimulationError(
      fmt::format("unstable: particle {} ({}) at ({}) m: {}; time {:.6g} s, step {}, time step "
                  "{:.3g} s limited by {}{}",
                  store.id()[particle], model_.materials[store.material()[particle]].name, place,
                  cause, time_, step_, vote_.time_step, vote_.reason, who));
}

void Simulation::fail_to_advance() const {
  std::string const cause = fmt::format("a time step of {} s ({}) does not move the clock",
                                        vote_.time_step, vote_.reason);
  if (vote_.particle != Vote::nobody) {
    auto const id = model_.particles.id();
    fail(static_cast<std::size_t>(std::find(id.begin(), id.end(), vote_.particle) - id.begin()),
         cause);
  }
  throw SimulationError(fmt::format("{}; time {:.6g} s, step {}", cause, time_, step_));
}

ConservedSums Simulation::sums() const {
  ParticleStore const& store = model_.particles;
  auto const mass = store.scalar(Field::mass);
  auto const energy = store.scalar(Field::specific_energy);
  auto const add = [&](std::size_t begin, std::size_t end) {
    ConservedSums sum;
    for (std::size_t i = begin; i < end; ++i) {
      sum.mass += mass[i];
      sum.internal_energy += mass[i] * energy[i];
      for (int axis = 0; axis < model_.dimension; ++axis) {
        auto const k = static_cast<std::size_t>(axis);
        double const v = store.component(Field::velocity, axis)[i];
        sum.kinetic_energy += 0.5 * mass[i] * v * v;
        sum.momentum[k] += mass[i] * v;
        sum.potential_energy -=
            mass[i] * model_.gravity[k] * store.component(Field::position, axis)[i];
      }
    }
    return sum;
  };
  auto const combine = [](ConservedSums a, ConservedSums const& b) {
    a.mass += b.mass;
    a.internal_energy += b.internal_energy;
    a.kinetic_energy += b.kinetic_energy;
    a.potential_energy += b.potential_energy;
    for (std::size_t k = 0; k < 3; ++k) a.momentum[k] += b.momentum[k];
    return a;
  };
  ConservedSums total =
      reduce_blocks(store.range(Kind::fluid).size(), ConservedSums{}, add, combine);
  total.wall_impulse = wall_impulse_;
  return total;
}

}  // namespace moraine
