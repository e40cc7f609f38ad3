// Period and decay of a standing wave in a run.
#pragma once

#include <cstdint>

#include "setup/case.hpp"

namespace moraine {

struct WaveRun {
  double period = 0.0;        // by that of linear theory, - 1
  double loss = 0.0;          // logarithm of the amplitude that is lost in a period
  double energy_drift = 0.0;  // of the total energy, by that of the wave at the start
  std::uint64_t steps = 0;
};

/// Runs a case like cases/standing-wave, flat at the start and with the velocities of the wave, for
/// so many periods. What is followed is the amplitude of the mode: the sum over all particles of
/// their velocity times that of the exact wave at the start there, over that of its square. Period:
/// from its first to its last zero. Loss: from the start to its last extremum.
WaveRun run_wave(Case const& c, int periods);

/// Decay of the amplitude in a period by linear theory, 2 nu k^2 T, with the viscosity of the case.
double exact_wave_loss(Case const& c);

}  // namespace moraine
