// What goes on beside the steps of a run: checkpoints, the status for those who look on, requests.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "app/run_loop.hpp"
#include "base/timer.hpp"
#include "output/checkpoint/checkpoints.hpp"
#include "output/progress.hpp"
#include "output/run_status.hpp"

namespace moraine {

/// A stopwatch that runs from the start.
class WallClock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  void restart() { start_ = std::chrono::steady_clock::now(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A file by which somebody asks for something: looked for ten times a second at most, and taken
/// away when it is there.
class RequestFile {
 public:
  explicit RequestFile(std::filesystem::path file) : file_(std::move(file)) {}
  bool found();

 private:
  std::filesystem::path file_;
  WallClock since_look_;
};

/// Saves the run at intervals of wall time.
class Saver {
 public:
  explicit Saver(Run const& run) : run_(run), checkpoints_(run.folder) {}

  void save_when_due();
  /// Guards look first, so that what is kept is a good state.
  void save();
  Timers const& timers() const { return timers_; }

 private:
  Run const& run_;
  Checkpoints checkpoints_;
  Timers timers_;
  int timer_ = timers_.add("checkpoints");
  WallClock since_save_;
};

/// Where the time of a run went: steps, output, checkpoints.
Timers all_timers(Run const& run, Saver const& saver);

/// Keeps status.json up to date. A status that cannot be written is told once, and ends nothing.
class StatusKeeper {
 public:
  StatusKeeper(Run const& run, Saver const& saver, Progress& progress)
      : run_(run), saver_(saver), progress_(progress) {}

  void update_when_due();
  void write(RunPhase phase, std::string const& reason);
  double wall_time() const { return since_start_.seconds(); }  // s

 private:
  RunStatus status_of(RunPhase phase, std::string const& reason) const;

  Run const& run_;
  Saver const& saver_;
  Progress& progress_;
  StatusPace pace_;
  WallClock since_start_;
  bool warned_ = false;
};

}  // namespace moraine
