// How a run stands, for people and programs that look on: DIR/status.json.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/timer.hpp"
#include "output/vote_tally.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// What a run is doing. `stopped`: on request, it can go on; `broken`: a guard, a full disk or a
/// lack of memory ended it.
enum class RunPhase : std::uint8_t { running, ended, stopped, broken };

/// The word for it in files: "running", "ended", "stopped", "broken".
std::string_view phase_name(RunPhase phase);

/// What the status tells beside what the simulation knows.
struct RunStatus {
  RunPhase phase = RunPhase::running;
  std::string reason;                      // why it ended; empty while it runs
  double wall_time = 0.0;                  // s, of the whole run, through its checkpoints
  std::optional<double> steps_per_second;  // over the last few seconds
  std::optional<double> time_left;         // s
  std::vector<VoteShare> votes;            // of the whole run
  Timers timers;                           // since it was started or resumed
  std::vector<std::string> remarks;        // gauges that saw nothing and the like
};

/// Writes the status as JSON, in SI units. The file appears complete or not at all. Throws
/// OutputError.
void write_status(std::filesystem::path const& path, Simulation const& simulation,
                  RunStatus const& status);

/// Says when a status is due, and measures how fast the run is: over about the last three seconds.
class StatusPace {
 public:
  using Clock = std::chrono::steady_clock;

  /// True once a second, and the first time.
  bool due();

  /// Call when the status is made.
  void measure(Simulation const& simulation);

  std::optional<double> steps_per_second() const { return steps_per_second_; }
  std::optional<double> time_left() const { return time_left_; }  // s

 private:
  struct Sample {
    Clock::time_point clock;
    double time;
    std::uint64_t step;
  };
  std::vector<Sample> samples_;
  std::optional<Clock::time_point> last_;
  std::optional<double> steps_per_second_, time_left_;
};

}  // namespace moraine
