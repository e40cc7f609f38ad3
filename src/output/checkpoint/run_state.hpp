// What a checkpoint of a run holds, in one place for both directions.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "output/run_recorder.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// Saves the number of the layout of checkpoints, or throws std::runtime_error when it is another
/// one than this program's.
void exchange_layout(Archive& archive);

/// Saves case, simulation and recorder: all that is needed to go on.
void save_run(Archive& archive, Simulation& simulation, RunRecorder& recorder);

/// Whether the run saved in a checkpoint file of this folder had nothing left to compute. Throws
/// like restore_run.
bool has_ended(std::filesystem::path const& checkpoint, std::filesystem::path const& folder);

/// A run as it was when it was saved.
struct RestoredRun {
  Case c;
  std::string simd;  // simd_flavour of the program that saved it: others give other last digits
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<RunRecorder> recorder;
};

/// The run saved in a checkpoint file of this folder, whose files are cut back to that moment.
/// Throws std::runtime_error when the checkpoint was written by another version of its layout or
/// does not fit the case in it, InputErrors when an STL file kept in the folder is gone or was
/// changed, OutputError when the folder cannot be written.
RestoredRun restore_run(std::filesystem::path const& checkpoint,
                        std::filesystem::path const& folder, int threads);

}  // namespace moraine
