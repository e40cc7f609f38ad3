// A block that is thrown against a rigid wall: plane shocks in any material.
#pragma once

#include "setup/case.hpp"
#include "step/simulation.hpp"
#include "verify/particle_value.hpp"

namespace moraine {

inline constexpr double block_length = 1.0;  // m

/// One metre of a material in 1D, `spacing` [m] between particles, that flies with `speed` u [m/s]
/// towards a rigid wall at x = 0; default numerics, double precision. Seen from the material at
/// rest the wall is a piston of speed u. The far end is free: until the shock has come to it,
/// nothing comes back from there. The end of the run is never reached.
Case thrown_block(MaterialSpec const& material, double speed, double spacing);

/// Farthest place from the wall where a value falls below `level`, on the line between two
/// particles [m]; 0 if it does nowhere.
double crossing(Simulation const& simulation, ParticleValue value, double level);

struct Passage {
  double time = 0.0;   // s
  double place = 0.0;  // m
};

/// Runs until the crossing of `level` has come to `place` [m]; when and where it is then.
Passage run_until(Simulation& simulation, ParticleValue value, double level, double place);

/// Mean speed between two passages [m/s].
double speed_between(Passage const& first, Passage const& last);

/// Mean over the particles with from <= x <= to [m].
double mean_of(Simulation const& simulation, ParticleValue value, double from, double to);

}  // namespace moraine
