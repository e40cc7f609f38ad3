// How far a run is: a bar on a terminal, plain lines in a log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace moraine {

/// "1:05" minutes, "2:10:00" hours, "3 d 4 h"; "-" for what is no time. Seconds are rounded up.
std::string duration(double seconds);

/// State of a run after a step. Times in s.
struct ProgressReport {
  double time = 0.0;
  double end_time = 0.0;
  std::uint64_t step = 0;
  double time_step = 0.0;
  std::string_view limited_by;  // what limits the time step
  std::size_t particles = 0;
};

/// Where progress goes and which clock it follows; replaced in tests.
struct ProgressSink {
  std::ostream* stream;
  std::function<double()> clock;  // s, monotonic
  bool terminal;                  // redraw one line instead of writing several
  std::size_t columns;            // width of the terminal
};

/// Standard error, steady clock; a terminal if standard error is one.
ProgressSink standard_progress_sink();

/// Shows time, per cent, steps per second, particle updates per second, the time left, and the time
/// step with what limits it. On a terminal one line is redrawn at most ten times a second;
/// elsewhere a line is written at each tenth of the way and otherwise every five seconds at most.
/// Rates are averages over about the last three seconds; the way is counted from the first report.
class Progress {
 public:
  explicit Progress(ProgressSink sink = standard_progress_sink());
  ~Progress();
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;

  /// Call after every step; returns at once when it is too early to show anything.
  void update(ProgressReport const& report);

  /// Removes the bar so that other text can be written; the next update draws it again.
  void clear();

  /// Shows the last state and ends the line. Further calls do nothing.
  void finish();

 private:
  struct Sample {
    double clock;
    double time;
    std::uint64_t step;
  };
  struct Rates {
    double simulated_per_second;
    double steps_per_second;
  };

  bool due(double now, double fraction) const;
  void measure(double now, ProgressReport const& report);
  double fraction(double time, double end_time) const;
  std::string line() const;
  std::string bar(double fraction) const;
  void show();

  ProgressSink sink_;
  ProgressReport last_{};
  std::string limited_by_;
  std::optional<Sample> first_;
  Sample previous_{};  // at the last measurement of the rates
  std::optional<Rates> rates_;
  double shown_at_ = 0.0;
  int shown_tenth_ = 0;
  bool line_open_ = false;
  bool finished_ = false;
};

}  // namespace moraine
