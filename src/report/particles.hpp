// Particles of a run for the player of a report: some frames, some particles, few bits each.
#pragma once

#include <optional>

#include "report/blocks.hpp"
#include "report/run_files.hpp"
#include "report/shown_frames.hpp"

namespace moraine::report {

/// Frames for the player, read from the files of the run once; nothing where it has none that can
/// be read (`run.notes` says why).
std::optional<ShownFrames> frames_for_page(RunFiles& run, ParticleBudget const& budget);

/// Those frames as type Particles of the format. A note says what is not shown. Blocks are named by
/// the run's prefix.
Json particles_of(RunFiles const& run, ShownFrames const& shown, Blocks& blocks);

}  // namespace moraine::report
