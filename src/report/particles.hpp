// Particles of a run for the player of a report: some frames, some particles, few bits each.
#pragma once

#include <cstddef>

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

/// What may be shown of a run: numbers of bytes before compression.
struct ParticleBudget {
  std::size_t bytes = 11'000'000;
  std::size_t most_particles = 50'000;  // in a frame: what a browser draws and picks with ease
};

/// The particles of a run as type Particles of the format; null where it has no frames that can be
/// read (`run.notes` says why). Where not everything fits, frames are left out first, evenly, down
/// to some twenty, and then particles: those whose ids hash into a share, the same ones in all
/// frames and without any pattern. The note says so. Blocks are named by the run's prefix.
Json particles_of(RunFiles& run, ParticleBudget const& budget, Blocks& blocks);

}  // namespace moraine::report
