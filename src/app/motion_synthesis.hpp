// moraine motion synthesise, and what it shares with moraine motion.
#pragma once

#include "app/motion_command.hpp"

namespace moraine {

/// Makes the options about written motions known to a command.
void add_motion_outputs(CLI::App& command, MotionOutputs& out);

/// Writes the record and its displacement where that is asked for. Throws OutputError.
void write_motion(GroundRecord const& record, MotionOutputs const& out);

/// Runs the subcommand: its exit code, 1 where the fit is not close.
int synthesise_motion(MotionOptions const& options);

}  // namespace moraine
