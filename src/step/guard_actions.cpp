// What the steps of a simulation have to do with its guards.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "step/simulation.hpp"

namespace moraine {

/// Rates that are made anew belong to a state that a run, or a stage, starts with.
void Simulation::watch() {
  if (half_step_factor_ == 0.0)
    guards_.begin(*this);
  else
    guards_.watch(*this, fastest_ + speed_of_walls());
}

void Simulation::fail(Finding finding) const {
  std::vector<Finding> findings;
  findings.push_back(std::move(finding));
  throw error_of({model_, time_, step_, vote_, guards_.votes()}, std::move(findings));
}

void Simulation::fail_to_advance() const {
  auto const id = model_.particles.id();
  auto const who = std::find(id.begin(), id.end(), vote_.particle);
  std::vector<Suspect> suspects;
  if (who != id.end()) suspects.push_back({static_cast<std::size_t>(who - id.begin()), 0.0});
  fail({Guard::clock, std::move(suspects), [this](std::size_t) {
          return fmt::format("a time step of {} s ({}) does not move the clock", vote_.time_step,
                             vote_.reason);
        }});
}

/// Books the work of damping: half a step at the rates that have just been made.
void Simulation::damp(double half) {
  double const damping = stages_.damping();
  damping_power_ = damping > 0.0 ? power_of_damping(model_.particles, damping, half) : 0.0;
  booked_.damping += half * damping_power_;
}

}  // namespace moraine
