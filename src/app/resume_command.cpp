// moraine resume: goes on with a run from its newest whole checkpoint.
#include <fmt/core.h>
#include <omp.h>

#include <filesystem>

#include "app/commands.hpp"
#include "app/run_loop.hpp"
#include "base/input_error.hpp"
#include "base/simd_width.hpp"
#include "output/checkpoint/checkpoints.hpp"
#include "output/checkpoint/run_state.hpp"
#include "output/run_folder.hpp"
#include "output/run_lock.hpp"

namespace moraine {
namespace {

[[noreturn]] void refuse(std::string const& folder, std::string rule, std::string hint) {
  throw InputErrors({{"moraine resume", 0, 0, "folder", fmt::format("\"{}\"", folder),
                      std::move(rule), std::move(hint)}});
}

[[noreturn]] void refuse_held(std::string const& folder) {
  refuse(folder, "belongs to a run that is still going on", "wait for its end, or stop it");
}

std::filesystem::path newest_checkpoint(std::string const& folder) {
  std::vector<std::string> skipped;
  auto const found = Checkpoints(folder).newest(skipped);
  for (std::string const& why : skipped) fmt::print(stderr, "passed over: {}\n", why);
  if (!found && holds_a_run(folder))
    refuse(folder, "has no whole checkpoint", "start again: moraine run CASE --force");
  if (!found) refuse(folder, "holds no run", "name the folder of a run");
  return *found;
}

}  // namespace

int resume_run(ResumeOptions const& options) {
  if (options.threads > 0) omp_set_num_threads(options.threads);
  int const threads = omp_get_max_threads();
  if (!std::filesystem::is_directory(options.folder))
    refuse(options.folder, "is not a folder", "name the folder of a run");
  if (RunLock::is_held(options.folder)) refuse_held(options.folder);
  auto const checkpoint = newest_checkpoint(options.folder);
  // Killed between its last step and its last file, a run still has to write its end.
  if (has_ended(checkpoint, options.folder) && has_written_its_end(options.folder)) {
    fmt::print("{} has reached its end: there is nothing left to do\n", options.folder);
    return ExitCode::done;
  }
  auto const lock = RunLock::take(options.folder);
  if (!lock) refuse_held(options.folder);
  RestoredRun restored = restore_run(checkpoint, options.folder, threads);
  // What is newer is damaged or unfinished, and must not be taken for newer than what comes.
  Checkpoints(options.folder).forget_newer(checkpoint);
  std::error_code ignored;
  std::filesystem::remove(std::filesystem::path(options.folder) / "stop", ignored);
  Run const run{restored.c, *restored.simulation, *restored.recorder, options.folder};
  say_start(run, threads);
  if (restored.simd != simd_flavour)
    fmt::print(stderr,
               "warning: the run was saved by a program with {} instructions, this one has {}: it "
               "goes on, but not to the same last digits as without the stop\n",
               restored.simd, simd_flavour);
  fmt::print("goes on at time {:.6g} s, step {}\n", run.simulation.time(), run.simulation.step());
  return run_to_end(run);
}

}  // namespace moraine
