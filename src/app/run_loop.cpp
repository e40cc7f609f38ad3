#include "app/run_loop.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <exception>

#include "app/commands.hpp"
#include "base/simd.hpp"
#include "output/checkpoint/checkpoints.hpp"
#include "output/checkpoint/run_state.hpp"
#include "output/output_error.hpp"
#include "output/progress.hpp"
#include "output/timing_table.hpp"
#include "step/simulation_error.hpp"

namespace moraine {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t stop_requested = 0;

/// The first signal asks for a clean stop; the second finds the default handler and ends at once.
void request_stop(int) {
  stop_requested = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Looks for the file `stop` ten times a second, and takes it away when it is there.
class StopFile {
 public:
  explicit StopFile(std::filesystem::path file) : file_(std::move(file)) {}
  bool found() {
    if (seconds_since(looked_) < 0.1) return false;
    looked_ = Clock::now();
    std::error_code ignored;
    return std::filesystem::remove(file_, ignored);
  }

 private:
  std::filesystem::path file_;
  Clock::time_point looked_ = Clock::now();
};

/// Saves the run at intervals of wall time.
class Saver {
 public:
  explicit Saver(Run const& run) : run_(run), checkpoints_(run.folder) {}

  void save_when_due() {
    double const interval = run_.c.output.checkpoint_interval;
    if (interval > 0.0 && seconds_since(last_) >= interval) save();
  }
  /// Guards look first, so that what is kept is a good state.
  void save() {
    run_.simulation.check();
    ScopedTimer const timing(timers_, timer_);
    run_.recorder.sync();
    checkpoints_.save(run_.simulation.step(),
                      [&](Archive& archive) { save_run(archive, run_.simulation, run_.recorder); });
    last_ = Clock::now();
  }
  Timers const& timers() const { return timers_; }

 private:
  Run const& run_;
  Checkpoints checkpoints_;
  Timers timers_;
  int timer_ = timers_.add("checkpoints");
  Clock::time_point last_ = Clock::now();
};

ProgressReport report(Simulation const& simulation) {
  return {simulation.time(),        simulation.model().time.end,
          simulation.step(),        simulation.time_step(),
          simulation.vote().reason, simulation.particles().range(Kind::fluid).size()};
}

void say_end(Run const& run, Timers const& saving, std::string const& reason, double seconds) {
  Simulation const& simulation = run.simulation;
  Timers timers = simulation.timers();
  timers.include(run.recorder.timers());
  timers.include(saving);
  fmt::print("\n{}: time {:.6g} s, {} steps in {:.2f} s\n", reason, simulation.time(),
             simulation.step(), seconds);
  if (simulation.lost().count > 0)
    fmt::print("{} particles left the domain and were removed ({:.4g} kg, {:.4g} J)\n",
               simulation.lost().count, simulation.lost().mass, simulation.lost().energy);
  if (!simulation.running() && simulation.stages_to_come() > 0)
    fmt::print("{} stages never began: the condition of the one before did not come true\n",
               simulation.stages_to_come());
  SmoothingClips const& clips = simulation.smoothing_clips();
  if (clips.at_least + clips.at_most > 0)
    fmt::print(
        "smoothing lengths were cut off: of up to {} particles at {:.4g} m "
        "(resolution.smoothing.least), of up to {} at {:.4g} m (most)\n",
        clips.at_least, simulation.model().numerics.least_smoothing_length(), clips.at_most,
        simulation.model().numerics.largest_smoothing_length());
  for (std::string const& remark : run.recorder.remarks()) fmt::print("{}\n", remark);
  std::string const folder = run.folder.string();
  fmt::print(
      "\n{}\nresults in {}: particles.pvd (ParaView), gauges.csv, sums.csv; pictures: "
      "moraine plot {}\n",
      timing_table(timers, seconds), folder, folder);
  if (simulation.running()) fmt::print("to go on: moraine resume {}\n", folder);
}

/// What is left to do when the run cannot go on: tell why, and keep what there is.
int give_up(Run const& run, std::string const& reason, std::vector<Flag> const& flags,
            double seconds, ExitCode code) {
  fmt::print(stderr, "{}\n", reason);
  try {
    auto const snapshot = run.recorder.give_up(run.simulation, reason, flags, seconds);
    fmt::print(stderr, "the particles as they were: {}{}\n", snapshot.string(),
               flags.empty() ? "" : "; the array \"guard\" flags who is named");
  } catch (std::exception const& error) {
    fmt::print(stderr, "nor could the particles be written: {}\n", error.what());
  }
  std::vector<std::string> skipped;
  if (auto const good = Checkpoints(run.folder).newest(skipped))
    fmt::print(stderr, "last good state: {}; to go on from it: moraine resume {}\n", good->string(),
               run.folder.string());
  return code;
}

/// Tells which stages have begun since; returns how many have begun at all.
std::size_t say_stages(Simulation const& simulation, std::size_t told, Progress& progress) {
  auto const& events = simulation.stage_events();
  for (; told < events.size(); ++told) {
    progress.clear();
    StageEvent const& event = events[told];
    fmt::print("stage \"{}\" begins at time {:.6g} s, step {}: {}\n", event.stage, event.time,
               event.step, event.cause);
  }
  return told;
}

/// Steps until the end or a request to stop; true if it was stopped.
bool advance(Run const& run, Saver& saver, Progress& progress) {
  StopFile stop_file(run.folder / "stop");
  std::size_t announced = run.simulation.stage_events().size();
  while (run.simulation.running()) {
    if (stop_requested != 0 || stop_file.found()) return true;
    run.simulation.advance();
    run.recorder.tell(run.simulation);
    announced = say_stages(run.simulation, announced, progress);
    saver.save_when_due();
    progress.update(report(run.simulation));
  }
  return false;
}

}  // namespace

void say_start(Run const& run, int threads) {
  auto const& store = run.simulation.particles();
  Case const& c = run.c;
  fmt::print(
      "{}\n{}D, {} fluid and {} wall particles, spacing {:.4g} m, h {:.4g} m, kernel {}, {} "
      "threads, {}\n",
      c.title.empty() ? c.file : c.title, c.dimension, store.range(Kind::fluid).size(),
      store.range(Kind::wall).size(), c.numerics.spacing, c.numerics.smoothing_length(),
      kernel_name(c.numerics.kernel), threads, simd_flavour);
  if (double const finest = run.simulation.model().finest_spacing; finest < c.numerics.spacing)
    fmt::print("finest spacing of a region {:.4g} m\n", finest);
  if (StartInfo const& from = c.start.info; !c.start.run.empty())
    fmt::print("particles from {} of {}, time {:.6g} s, step {}\n", from.checkpoint, from.run,
               from.time, from.step);
}

int run_to_end(Run const& run) {
  auto const start = Clock::now();
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  run.simulation.on_new_rates(
      [&run](Simulation const& simulation) { run.recorder.tell_new_rates(simulation); });
  Saver saver(run);
  Progress progress;
  auto const stopped_at = [&](std::exception const& error) {
    return fmt::format("the run stopped at time {:.6g} s, step {}: {}", run.simulation.time(),
                       run.simulation.step(), error.what());
  };
  try {
    saver.save();
    bool const stopped = advance(run, saver, progress);
    saver.save();
    progress.finish();
    std::string const reason = stopped ? "interrupted" : "end time reached";
    run.recorder.finish(run.simulation, reason, seconds_since(start));
    say_end(run, saver.timers(), reason, seconds_since(start));
    return stopped ? ExitCode::interrupted : ExitCode::done;
  } catch (SimulationError const& error) {
    progress.finish();
    return give_up(run, error.what(), error.flags(), seconds_since(start), ExitCode::unstable);
  } catch (OutputError const& error) {
    progress.finish();
    return give_up(run, stopped_at(error), {}, seconds_since(start), ExitCode::not_written);
  } catch (std::exception const& error) {  // no memory: not the physics
    progress.finish();
    return give_up(run, stopped_at(error), {}, seconds_since(start), ExitCode::failed);
  }
}

}  // namespace moraine
