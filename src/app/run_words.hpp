// What a run says on the terminal.
#pragma once

#include <cstddef>
#include <string>

#include "app/run_keepers.hpp"
#include "app/run_loop.hpp"
#include "output/progress.hpp"

namespace moraine {

/// What progress shows of a run.
ProgressReport progress_of(Simulation const& simulation);

/// Tells which stages have begun since `told`; returns how many have begun at all.
std::size_t say_stages(Simulation const& simulation, std::size_t told, Progress& progress);

/// How a run ended, how long it took, and whether its page could be written.
struct EndWords {
  std::string reason;
  double seconds = 0.0;
  bool page = true;
};

/// How a run ended, what it lost, where its time went and where its results are.
void say_end(Run const& run, Saver const& saver, EndWords const& end);

}  // namespace moraine
