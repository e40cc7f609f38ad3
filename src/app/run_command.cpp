// moraine run: one case from start to end.
#include <fmt/core.h>
#include <omp.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/commands.hpp"
#include "app/run_loop.hpp"
#include "base/input_error.hpp"
#include "output/checkpoint/start_reader.hpp"
#include "output/output_error.hpp"
#include "output/references.hpp"
#include "output/run_folder.hpp"
#include "output/run_lock.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation_error.hpp"

namespace moraine {
namespace {

/// The rule of the function `output_of` in tools/lib.sh.
std::string default_output(std::string const& case_file) {
  auto const path = std::filesystem::weakly_canonical(case_file);
  std::string const name =
      path.stem() == "case" ? path.parent_path().filename().string() : path.stem().string();
  return "out/" + name;
}

[[noreturn]] void refuse_output(std::filesystem::path const& folder, std::string rule) {
  throw InputErrors({{"moraine run", 0, 0, "--output", fmt::format("\"{}\"", folder.string()),
                      std::move(rule), "choose another folder with --output"}});
}

/// Refuses a folder for results that cannot be one, or that holds others, before anything is
/// computed.
void check_output(std::filesystem::path const& folder, bool force) {
  auto const refuse = [&](std::string rule) { refuse_output(folder, std::move(rule)); };
  std::filesystem::path place = std::filesystem::absolute(folder);
  while (!std::filesystem::exists(place) && place.has_relative_path()) place = place.parent_path();
  if (!std::filesystem::is_directory(place))
    refuse(fmt::format("cannot be a folder: \"{}\" is a file", place.string()));
  if (access(place.c_str(), W_OK | X_OK) != 0)
    refuse(fmt::format("cannot be written: {}", std::strerror(errno)));
  if (RunLock::is_held(folder)) refuse("belongs to a run that is still going on");
  if (holds_a_run(folder) && !force)
    refuse("holds the results of a run; --force replaces them, moraine resume goes on with them");
}

/// A run cannot start from what it is about to replace.
void check_start_is_elsewhere(Case const& c, std::filesystem::path const& folder) {
  std::error_code ignored;
  if (!c.start.run.empty() && std::filesystem::equivalent(c.start.run, folder, ignored))
    throw InputErrors({problem_of(c, "start.run", "is the folder of this run's own results",
                                  "choose another folder with --output")});
}

/// The folder, made if needed, with the right to write into it.
RunLock locked_folder(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw OutputError(
        fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
  auto lock = RunLock::take(folder);
  if (!lock) refuse_output(folder, "belongs to a run that is still going on");
  return std::move(*lock);
}

/// The simulation with its first rates; a start that no law can answer is a mistake of the case.
Simulation started(Case const& c) {
  try {
    Simulation simulation(build_model(c));
    simulation.check();
    return simulation;
  } catch (SimulationError const& error) {
    throw InputErrors(
        {{c.file, 0, 0, "region", "", fmt::format("at the start: {}", error.what()), ""}});
  }
}

}  // namespace

int run_case(RunOptions const& options) {
  if (options.threads > 0) omp_set_num_threads(options.threads);
  int const threads = omp_get_max_threads();
  Case c = read_case(options.case_file);
  read_start(c);
  check_references(c);
  std::string const output =
      options.output.empty() ? default_output(options.case_file) : options.output;
  check_output(output, options.force);
  check_start_is_elsewhere(c, output);

  Simulation simulation = started(c);
  RunLock const lock = locked_folder(output);
  make_run_folder(output);
  write_start_copy(c, output);
  c.start.particles.reset();
  RunRecorder recorder(c, simulation, output, threads);
  Run const run{c, simulation, recorder, output};
  say_start(run, threads);
  return run_to_end(run);
}

}  // namespace moraine
