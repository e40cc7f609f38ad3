#include "app/run_loop.hpp"

#include <fmt/core.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
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

/// From here on a page takes more than a second or two.
constexpr std::uintmax_t much_to_read = 500'000'000;  // bytes

bool takes_long(std::filesystem::path const& folder) {
  std::uintmax_t bytes = 0;
  std::error_code none;
  for (auto const& entry : std::filesystem::directory_iterator(folder / "frames", none)) {
    auto const size = entry.file_size(none);
    if (!none) bytes += size;
  }
  return bytes > much_to_read;
}

/// A run with all that goes on beside its steps.
class Loop {
 public:
  explicit Loop(Run const& run) : run_(run) {}

  ExitCode to_end();

 private:
  bool advance();
  void tell_those_who_look_on();
  ExitCode after_end(bool stopped);
  ExitCode give_up(std::string const& reason, std::vector<Flag> const& flags, ExitCode code);
  bool write_page() const;
  void keep_what_there_is(std::string const& reason, std::vector<Flag> const& flags);
  std::string stopped_by(std::exception const& error) const {
    return fmt::format("the run stopped at time {:.6g} s, step {}: {}", run_.simulation.time(),
                       run_.simulation.step(), error.what());
  }

  Run const& run_;
  Saver saver_{run_};
  Progress progress_;
  StatusKeeper status_{run_, saver_, progress_};
  RequestFile snapshot_{run_.folder / "snapshot"};
};

char const* reason_of_end(bool stopped) { return stopped ? "interrupted" : "end time reached"; }

/// Steps until the end or a request to stop; true if it was stopped.
bool Loop::advance() {
  RequestFile stop(run_.folder / "stop");
  std::size_t announced = run_.simulation.stage_events().size();
  while (run_.simulation.running()) {
    if (stop_requested != 0 || stop.found()) return true;
    run_.simulation.advance();
    run_.recorder.tell(run_.simulation);
    announced = say_stages(run_.simulation, announced, progress_);
    saver_.save_when_due();
    tell_those_who_look_on();
    progress_.update(progress_of(run_.simulation));
  }
  return false;
}

/// Status and snapshots: the run does not depend on them, and outlives what goes wrong with them.
void Loop::tell_those_who_look_on() {
  status_.update_when_due();
  if (!snapshot_.found()) return;
  progress_.clear();
  try {
    fmt::print("snapshot: {}\n", run_.recorder.write_snapshot(run_.simulation).string());
  } catch (OutputError const& error) {
    fmt::print(stderr, "the snapshot is not there: {}; the run goes on\n", error.what());
  }
}

ExitCode Loop::to_end() {
  bool stopped = false;
  try {
    status_.update_when_due();
    saver_.save();
    stopped = advance();
    saver_.save();
    progress_.finish();
    run_.recorder.finish(run_.simulation, reason_of_end(stopped), run_.recorder.wall_time());
  } catch (SimulationError const& error) {
    return give_up(error.what(), error.flags(), ExitCode::unstable);
  } catch (OutputError const& error) {
    return give_up(stopped_by(error), {}, ExitCode::not_written);
  } catch (std::exception const& error) {  // no memory: not the physics
    return give_up(stopped_by(error), {}, ExitCode::failed);
  }
  return after_end(stopped);
}

/// All results are written: what fails from here on cannot make them those of a run that broke.
ExitCode Loop::after_end(bool stopped) {
  status_.write(stopped ? RunPhase::stopped : RunPhase::ended, reason_of_end(stopped));
  bool const page = write_page();
  say_end(run_, saver_, {reason_of_end(stopped), status_.wall_time(), page});
  return stopped ? ExitCode::interrupted : ExitCode::done;
}

/// The results are whole without their page: what goes wrong with it is told, and ends nothing.
bool Loop::write_page() const {
  auto const file = run_.folder / "report.html";
  if (takes_long(run_.folder)) {
    fmt::print("writing {}\n", file.string());
    std::fflush(stdout);
  }
  try {
    report::write_report({run_.folder}, {.file = file});
    return true;
  } catch (std::exception const& error) {
    fmt::print(stderr,
               "warning: {} could not be written: {}\nall other results are there; to try again: "
               "moraine report {}\n",
               file.string(), error.what(), run_.folder.string());
    return false;
  }
}

void Loop::keep_what_there_is(std::string const& reason, std::vector<Flag> const& flags) {
  try {
    auto const snapshot =
        run_.recorder.give_up(run_.simulation, reason, flags, run_.recorder.wall_time());
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
