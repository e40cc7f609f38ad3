#include "app/run_loop.hpp"

#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/run_keepers.hpp"
#include "app/run_words.hpp"
#include "output/checkpoint/checkpoints.hpp"
#include "output/output_error.hpp"
#include "output/progress.hpp"
#include "report/report.hpp"
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

/// A run with all that goes on beside its steps.
class Loop {
 public:
  explicit Loop(Run const& run) : run_(run) {}

  ExitCode to_end();

 private:
  bool advance();
  ExitCode give_up(std::string const& reason, std::vector<Flag> const& flags, ExitCode code);
  bool write_page() const;
  void keep_what_there_is(std::string const& reason, std::vector<Flag> const& flags) const;
  std::string stopped_by(std::exception const& error) const {
    return fmt::format("the run stopped at time {:.6g} s, step {}: {}", run_.simulation.time(),
                       run_.simulation.step(), error.what());
  }

  Run const& run_;
  Saver saver_{run_};
  StatusKeeper status_{run_, saver_};
  Progress progress_;
};

/// Steps until the end or a request to stop; true if it was stopped.
bool Loop::advance() {
  RequestFile stop(run_.folder / "stop"), snapshot(run_.folder / "snapshot");
  std::size_t announced = run_.simulation.stage_events().size();
  while (run_.simulation.running()) {
    if (stop_requested != 0 || stop.found()) return true;
    run_.simulation.advance();
    run_.recorder.tell(run_.simulation);
    announced = say_stages(run_.simulation, announced, progress_);
    saver_.save_when_due();
    status_.update_when_due();
    if (snapshot.found()) {
      progress_.clear();
      fmt::print("snapshot: {}\n", run_.recorder.write_snapshot(run_.simulation).string());
    }
    progress_.update(progress_of(run_.simulation));
  }
  return false;
}

ExitCode Loop::to_end() {
  try {
    status_.update_when_due();
    saver_.save();
    bool const stopped = advance();
    saver_.save();
    progress_.finish();
    std::string const reason = stopped ? "interrupted" : "end time reached";
    run_.recorder.finish(run_.simulation, reason, status_.wall_time());
    status_.write(stopped ? RunPhase::stopped : RunPhase::ended, reason);
    bool const shown = write_page();
    say_end(run_, saver_, reason, status_.wall_time());
    if (stopped) return ExitCode::interrupted;
    return shown ? ExitCode::done : ExitCode::not_written;
  } catch (SimulationError const& error) {
    return give_up(error.what(), error.flags(), ExitCode::unstable);
  } catch (OutputError const& error) {
    return give_up(stopped_by(error), {}, ExitCode::not_written);
  } catch (std::exception const& error) {  // no memory: not the physics
    return give_up(stopped_by(error), {}, ExitCode::failed);
  }
}

/// The results are whole without their page: what goes wrong with it is told, and ends nothing.
bool Loop::write_page() const {
  auto const file = run_.folder / "report.html";
  try {
    report::write_report({run_.folder}, {.file = file});
    return true;
  } catch (std::exception const& error) {
    fmt::print(stderr,
               "{} could not be written: {}\nall other results are there; to try again: "
               "moraine report {}\n",
               file.string(), error.what(), run_.folder.string());
    return false;
  }
}

void Loop::keep_what_there_is(std::string const& reason, std::vector<Flag> const& flags) const {
  try {
    auto const snapshot =
        run_.recorder.give_up(run_.simulation, reason, flags, status_.wall_time());
    fmt::print(stderr, "the particles as they were: {}{}\n", snapshot.string(),
               flags.empty() ? "" : "; the array \"guard\" flags who is named");
    status_.write(RunPhase::broken, reason);
    write_page();
  } catch (std::exception const& error) {
    fmt::print(stderr, "nor could the particles be written: {}\n", error.what());
  }
}

/// What is left to do when the run cannot go on: tell why, and keep what there is.
ExitCode Loop::give_up(std::string const& reason, std::vector<Flag> const& flags, ExitCode code) {
  progress_.finish();
  fmt::print(stderr, "{}\n", reason);
  keep_what_there_is(reason, flags);
  std::vector<std::string> skipped;
  if (auto const good = Checkpoints(run_.folder).newest(skipped))
    fmt::print(stderr, "last good state: {}; to go on from it: moraine resume {}\n", good->string(),
               run_.folder.string());
  return code;
}

}  // namespace

int run_to_end(Run const& run) {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  run.simulation.on_new_rates(
      [&run](Simulation const& simulation) { run.recorder.tell_new_rates(simulation); });
  return Loop(run).to_end();
}

}  // namespace moraine
