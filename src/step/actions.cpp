// What the actions of a step do to the state of the particles.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"
#include "step/bad_particles.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

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

}  // namespace

void Simulation::choose_time_step() {
  TimeSpec const& spec = model_.time;
  double const h = model_.numerics.smoothing_length();
  Vote vote{spec.courant * h / swept_.signal_speed, sound_limit,
            model_.particles.id()[swept_.particle]};
  vote = stricter(vote, acceleration_vote_);
  vote = stricter(vote, motion_vote_);
  vote = stricter(vote, vote_of_walls());
  vote = stricter(vote, vote_of_repulsion());
  vote = stricter(vote, vote_of_burn());
  vote = stricter(vote, vote_of_options());
  vote = stricter(vote, vote_of_expansion());
  if (stages_.damping() > 0.0)
    vote = stricter(vote, {0.5 / stages_.damping(), damping_limit, Vote::nobody});
  if (spec.fixed_step > 0.0) vote = {spec.fixed_step, fixed_limit, Vote::nobody};
  vote = stricter(vote, {spec.max_step, largest_limit, Vote::nobody});
  vote = stricter(vote, {spec.end - time_, end_of_run, Vote::nobody});
  vote_ = vote;
  if (!(time_ + vote.time_step > time_)) fail_to_advance();
  guards_.note(vote);
}

void Simulation::kick_and_drift() {
  ParticleStore& store = model_.particles;
  advance_stress(0.5 * vote_.time_step);
  std::size_t const count = store.range(Kind::fluid).size();
  double const dt = vote_.time_step;
  SmoothingLengths const h(model_);
  Components const velocity = components_of(store, Field::velocity);
  auto const far = [&](std::size_t i) {
    return !(dt * dt * square_of(velocity, i) <= h(i) * h(i));
  };
  auto const advance = [&](std::size_t begin, std::size_t end) {
    for (int axis = 0; axis < model_.dimension; ++axis) {
      auto x = store.component(Field::position, axis);
      auto v = store.component(Field::velocity, axis);
      auto const a = store.component(Field::acceleration, axis);
      for (std::size_t i = begin; i < end; ++i) {
        v[i] += 0.5 * dt * a[i];
        x[i] += dt * v[i];
      }
      if (!store.has(Field::drift)) continue;
      auto const drift = store.component(Field::drift, axis);
      for (std::size_t i = begin; i < end; ++i) x[i] += dt * drift[i];
    }
    auto const half_kick = [&](Field field, Field rate_field) {
      auto value = store.scalar(field);
      auto const rate = store.scalar(rate_field);
      for (std::size_t i = begin; i < end; ++i) value[i] += 0.5 * dt * rate[i];
    };
    if (density_is_state()) half_kick(Field::density, Field::density_rate);
    half_kick(Field::specific_energy, Field::energy_rate);
    for (std::size_t i = begin; i < end; ++i)
      if (far(i)) return i;
    return none;
  };
  std::size_t const bad = reduce_blocks(
      count, none, advance, [](std::size_t a, std::size_t b) { return std::min(a, b); });
  booked_.damping += 0.5 * dt * damping_power_;
  booked_.drift += dt * power_of_drift(store, model_.gravity);
  if (bad == none) return follow_density();
  fail({Guard::motion, all_bad(count, far), [&](std::size_t i) {
          return fmt::format(
              "it moves {:.4g} m in one step, farther than the smoothing length {:.4g} m",
              dt * std::sqrt(square_of(velocity, i)), h(i));
        }});
}

void Simulation::kick_and_check() {
  ParticleStore& store = model_.particles;
  std::size_t const count = store.range(Kind::fluid).size();
  double const half = predict_by();
  double const density_half = density_is_state() ? half : 0.0;
  double const damping = stages_.damping();
  book_walls();
  struct Outcome {
    Largest acceleration2, motion2, speed2;
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
  auto const is_state = [&](std::size_t i) {
    double sum = density[i] + energy[i];
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(model_.dimension); ++axis)
      sum += velocity[axis][i] * velocity[axis][i] + acceleration[axis][i] * acceleration[axis][i];
    return std::isfinite(sum) && density[i] > 0.0;
  };
  SmoothingLengths const h(model_);
  double const of_case = model_.numerics.smoothing_length();
  bool const varies = model_.numerics.smoothing.varies();
  auto const kick = [&](std::size_t begin, std::size_t end) {
    Outcome outcome;
    for (std::size_t i = begin; i < end; ++i) {
      density[i] += density_half * density_rate[i];
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
      // As if all had the smoothing length of the case: what counts is sqrt(h / a) and h / v.
      double const shrunk = varies ? of_case / h(i) : 1.0;
      outcome.acceleration2.include(acceleration2 * shrunk * shrunk, i);
      outcome.motion2.include(velocity2 * shrunk * shrunk, i);
      outcome.speed2.include(velocity2, i);
      if (outcome.bad == none && !is_state(i)) outcome.bad = i;
    }
    return outcome;
  };
  auto const combine = [](Outcome a, Outcome const& b) {
    a.acceleration2.include(b.acceleration2.value, b.acceleration2.particle);
    a.motion2.include(b.motion2.value, b.motion2.particle);
    a.speed2.include(b.speed2.value, b.speed2.particle);
    a.bad = std::min(a.bad, b.bad);
    return a;
  };
  Outcome const outcome = reduce_blocks(count, Outcome{}, kick, combine);
  if (outcome.bad != none)
    fail({Guard::finite, all_bad(count, [&](std::size_t i) { return !is_state(i); }),
          [&](std::size_t i) {
            return density[i] > 0.0
                       ? "its velocity, density, energy or acceleration is not a finite number"
                       : "its density is not positive";
          }});
  advance_stress(half);
  damp(half);
  auto const id = store.id();
  acceleration_vote_ = {model_.time.courant * std::sqrt(model_.numerics.smoothing_length() /
                                                        std::sqrt(outcome.acceleration2.value)),
                        acceleration_limit, id[outcome.acceleration2.particle]};
  fastest_ = std::sqrt(outcome.speed2.value);
  motion_vote_ = {longest_motion * of_case / std::sqrt(outcome.motion2.value), motion_limit,
                  id[outcome.motion2.particle]};
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
  total.penalty_energy = option_outcome_.penalty_energy;
  total.potential_energy += pushed_.energy;
  return total;
}

}  // namespace moraine
