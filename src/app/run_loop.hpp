// The loop of a run, whether it starts or goes on: steps, output, checkpoints, requests to stop.
#pragma once

#include <filesystem>

#include "output/run_recorder.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// What the loop works with.
struct Run {
  Case const& c;
  Simulation& simulation;
  RunRecorder& recorder;
  std::filesystem::path folder;
};

/// Says what is going to be computed.
void say_start(Run const& run, int threads);

/// Advances to the end, or until Ctrl-C, SIGTERM or a file `stop` in the folder ask for a clean
/// end. Writes a checkpoint at the start, at intervals of wall time, and when it is stopped.
/// Returns the exit code of the program; whatever stops it early has then been told and written
/// down.
int run_to_end(Run const& run);

}  // namespace moraine
