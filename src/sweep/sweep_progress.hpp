// How far a sweep is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "output/progress.hpp"

namespace moraine {

/// Members by what has become of them; `running` holds the seconds that each has run.
struct SweepCount {
  std::size_t total = 0;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::vector<double> running;
  std::size_t at_once = 1;
};

/// "7 of 12 done, 1 failed, 2 running, ETA 3:20": one line that is redrawn on a terminal, a new
/// line at each change elsewhere. The time left is estimated from the members that have ended.
class SweepProgress {
 public:
  explicit SweepProgress(ProgressSink sink = standard_progress_sink());

  /// Seconds that a member took which has ended.
  void learn(double seconds);
  void update(SweepCount const& count);
  /// A line of text above the progress.
  void say(std::string const& text);
  void finish();

  double now() const { return sink_.clock(); }

 private:
  std::string line(SweepCount const& count) const;
  void clear();

  ProgressSink sink_;
  double learnt_ = 0.0;
  std::size_t members_ = 0;
  std::string counts_;  // as last shown
  double shown_at_ = 0.0;
  bool line_open_ = false;
};

}  // namespace moraine
