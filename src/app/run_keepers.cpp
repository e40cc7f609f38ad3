#include "app/run_keepers.hpp"

#include <fmt/core.h>

#include <system_error>
#include <utility>

#include "output/checkpoint/run_state.hpp"
#include "output/output_error.hpp"

namespace moraine {

bool RequestFile::found() {
  if (since_look_.seconds() < 0.1) return false;
  since_look_.restart();
  std::error_code ignored;
  return std::filesystem::remove(file_, ignored);
}

void Saver::save_when_due() {
  double const interval = run_.c.output.checkpoint_interval;
  if (interval > 0.0 && since_save_.seconds() >= interval) save();
}

void Saver::save() {
  run_.simulation.check();
  ScopedTimer const timing(timers_, timer_);
  run_.recorder.sync();
  checkpoints_.save(run_.simulation.step(),
                    [&](Archive& archive) { save_run(archive, run_.simulation, run_.recorder); });
  since_save_.restart();
}

Timers all_timers(Run const& run, Saver const& saver) {
  Timers timers = run.simulation.timers();
  timers.include(run.recorder.timers());
  timers.include(saver.timers());
  return timers;
}

void StatusKeeper::update_when_due() {
  if (!pace_.due()) return;
  pace_.measure(run_.simulation);
  write(RunPhase::running, "");
}

void StatusKeeper::write(RunPhase phase, std::string const& reason) {
  auto const file = run_.folder / "status.json";
  try {
    write_status(file, run_.simulation, status_of(phase, reason));
  } catch (OutputError const& error) {
    if (std::exchange(warned_, true)) return;
    progress_.clear();
    fmt::print(stderr, "warning: the status is not up to date: {}; the run does not need it\n",
               error.what());
  }
}

RunStatus StatusKeeper::status_of(RunPhase phase, std::string const& reason) const {
  RunStatus status{.phase = phase,
                   .reason = reason,
                   .wall_time = run_.recorder.wall_time(),
                   .steps_per_second = pace_.steps_per_second(),
                   .time_left = pace_.time_left(),
                   .votes = run_.recorder.votes().shares(),
                   .timers = all_timers(run_, saver_),
                   .remarks = {}};
  if (phase != RunPhase::running) {
    status.time_left.reset();
    status.remarks = run_.recorder.remarks();
  }
  return status;
}

}  // namespace moraine
