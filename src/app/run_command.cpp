// moraine run: one case from start to end.
#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>

#include "app/commands.hpp"
#include "base/input_error.hpp"
#include "base/simd.hpp"
#include "output/progress.hpp"
#include "output/run_recorder.hpp"
#include "output/timing_table.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation_error.hpp"

namespace moraine {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

/// The first signal asks for a clean stop; the second finds the default handler and ends at once.
void request_stop(int) {
  stop_requested = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

/// The rule of the function `output_of` in tools/lib.sh.
std::string default_output(std::string const& case_file) {
  auto const path = std::filesystem::weakly_canonical(case_file);
  std::string const name =
      path.stem() == "case" ? path.parent_path().filename().string() : path.stem().string();
  return "out/" + name;
}

/// Refuses a folder for results that cannot be one, before anything is computed.
void check_output(std::filesystem::path const& folder) {
  auto const refuse = [&](std::string rule) {
    throw InputErrors({{"moraine run", 0, 0, "--output", fmt::format("\"{}\"", folder.string()),
                        std::move(rule), "choose another folder with --output"}});
  };
  std::filesystem::path place = std::filesystem::absolute(folder);
  while (!std::filesystem::exists(place) && place.has_relative_path()) place = place.parent_path();
  if (!std::filesystem::is_directory(place))
    refuse(fmt::format("cannot be a folder: \"{}\" is a file", place.string()));
  if (access(place.c_str(), W_OK | X_OK) != 0)
    refuse(fmt::format("cannot be written: {}", std::strerror(errno)));
}

/// The simulation with its first rates; a start that no law can answer is a mistake of the case.
Simulation started(Case const& c) {
  try {
    return Simulation(build_model(c));
  } catch (SimulationError const& error) {
    throw InputErrors(
        {{c.file, 0, 0, "region", "", fmt::format("at the start: {}", error.what()), ""}});
  }
}

void say_start(Case const& c, Simulation const& simulation, int threads) {
  auto const& store = simulation.particles();
  fmt::print(
      "{}\n{}D, {} fluid and {} wall particles, spacing {:.4g} m, h {:.4g} m, kernel {}, {} "
      "threads, "
      "{}\n",
      c.title.empty() ? c.file : c.title, c.dimension, store.range(Kind::fluid).size(),
      store.range(Kind::wall).size(), c.numerics.spacing, c.numerics.smoothing_length(),
      kernel_name(c.numerics.kernel), threads, simd_flavour);
}

ProgressReport report(Simulation const& simulation) {
  return {simulation.time(),        simulation.model().time.end,
          simulation.step(),        simulation.time_step(),
          simulation.vote().reason, simulation.particles().range(Kind::fluid).size()};
}

void say_end(Simulation const& simulation, RunRecorder const& recorder, std::string const& reason,
             double seconds, std::string const& output) {
  Timers timers = simulation.timers();
  timers.include(recorder.timers());
  fmt::print("\n{}: time {:.6g} s, {} steps in {:.2f} s\n", reason, simulation.time(),
             simulation.step(), seconds);
  if (simulation.lost().count > 0)
    fmt::print("{} particles left the domain and were removed ({:.4g} kg, {:.4g} J)\n",
               simulation.lost().count, simulation.lost().mass, simulation.lost().energy);
  fmt::print(
      "\n{}\nresults in {}: particles.pvd (ParaView), gauges.csv, sums.csv; pictures: "
      "moraine plot {}\n",
      timing_table(timers, seconds), output, output);
}

/// What is left to do when the run cannot go on: tell why, and keep what there is.
int give_up(RunRecorder& recorder, Simulation const& simulation, std::string const& reason,
            double seconds, ExitCode code) {
  fmt::print(stderr, "{}\n", reason);
  try {
    auto const snapshot = recorder.give_up(simulation, reason, seconds);
    fmt::print(stderr, "the particles as they were: {}\n", snapshot.string());
  } catch (std::exception const& error) {
    fmt::print(stderr, "nor could the particles be written: {}\n", error.what());
  }
  return code;
}

}  // namespace

int run_case(RunOptions const& options) {
  using Clock = std::chrono::steady_clock;
  if (options.threads > 0) omp_set_num_threads(options.threads);
  int const threads = omp_get_max_threads();
  Case const c = read_case(options.case_file);
  std::string const output =
      options.output.empty() ? default_output(options.case_file) : options.output;
  check_output(output);
  auto const start = Clock::now();
  auto const seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };

  Simulation simulation = started(c);
  RunRecorder recorder(c, simulation, output, threads);
  say_start(c, simulation, threads);
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  Progress progress;
  try {
    while (simulation.running() && stop_requested == 0) {
      simulation.advance();
      recorder.tell(simulation);
      progress.update(report(simulation));
    }
  } catch (SimulationError const& error) {
    progress.clear();
    return give_up(recorder, simulation, error.what(), seconds(), ExitCode::unstable);
  } catch (std::exception const& error) {  // no memory, no room on the disk: not the physics
    progress.clear();
    std::string const reason = fmt::format("the run stopped at time {:.6g} s, step {}: {}",
                                           simulation.time(), simulation.step(), error.what());
    return give_up(recorder, simulation, reason, seconds(), ExitCode::failed);
  }
  progress.finish();
  bool const stopped = stop_requested != 0;
  std::string const reason = stopped ? "interrupted" : "end time reached";
  recorder.finish(simulation, reason, seconds());
  say_end(simulation, recorder, reason, seconds(), output);
  return stopped ? ExitCode::interrupted : ExitCode::done;
}

}  // namespace moraine
