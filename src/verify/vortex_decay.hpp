// How fast the vortices of Taylor and Green decay in a run.
#pragma once

#include <cstdint>
#include <vector>

#include "setup/case.hpp"

namespace moraine {

struct VortexSample {
  double time = 0.0;      // s
  double excess = 0.0;    // decay of the logarithm of the kinetic energy so far / exact decay, - 1
  double velocity = 0.0;  // relative L2 error of the velocities
};

struct VortexRun {
  std::vector<VortexSample> samples;
  double momentum = 0.0;  // m/s, of all particles by their mass, at the end
  double energy_drift =
      0.0;  // kinetic and internal, at the end, by the kinetic energy at the start
  std::uint64_t steps = 0;
};

/// Runs a case like cases/taylor-green, a square of one linear liquid with largest velocity 1 m/s,
/// to the last of `times` [s]. It starts with the pressure of the exact solution, which the case
/// file cannot say: the even one of the file makes waves of sound.
VortexRun run_vortices(Case c, std::vector<double> const& times);

}  // namespace moraine
