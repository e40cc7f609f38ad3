// Who is guilty where a guard has found something, and what is said of them.
#pragma once

#include <cstdint>

#include "step/guard.hpp"
#include "step/guard_bounds.hpp"

namespace moraine {

class Simulation;

/// What guards know at the moment in which they stop a run.
struct GuardContext {
  Simulation const& simulation;
  GuardBounds const& bounds;
  StateRange const& start;
  double energy_error = 0.0;      // J
  double energy_scale = 0.0;      // J
  std::uint64_t short_steps = 0;  // in a row
};

/// Whether the total energy is constant at all: not where gravity acts along a periodic axis, on
/// which particles fall for ever.
bool has_budget(Model const& model);

/// What an optional guard has found. No single particle takes a budget out of balance: the one with
/// the most energy of its own, kinetic and above that of the start, is named for it.
Finding finding_of(Guard guard, GuardContext const& context);

}  // namespace moraine
