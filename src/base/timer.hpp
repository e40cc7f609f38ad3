// Where the time of a run goes: labelled stopwatches on a monotonic clock.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// Sum over all intervals of one label.
struct TimerEntry {
  std::string label;
  std::chrono::nanoseconds total{0};
  std::uint64_t calls = 0;

  double seconds() const { return std::chrono::duration<double>(total).count(); }
};

/// A list of labelled stopwatches. Labels are added at setup; timing itself never allocates.
/// One thread at a time may time into one object; nested intervals count in both labels.
class Timers {
 public:
  using Clock = std::chrono::steady_clock;

  /// Adds a label and returns its id; a label that is known keeps its id.
  int add(std::string_view label) {
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (entries_[i].label == label) return static_cast<int>(i);
    entries_.push_back({std::string(label), {}, 0});
    return static_cast<int>(entries_.size()) - 1;
  }

  /// Counts one interval for the label with this id, which must come from `add`.
  void record(int id, std::chrono::nanoseconds interval) {
    TimerEntry& entry = entries_[static_cast<std::size_t>(id)];
    entry.total += interval;
    ++entry.calls;
  }

  /// Adds the labels of another object behind its own; times of the same label are summed.
  void include(Timers const& other) {
    for (TimerEntry const& entry : other.entries_) {
      TimerEntry& mine = entries_[static_cast<std::size_t>(add(entry.label))];
      mine.total += entry.total;
      mine.calls += entry.calls;
    }
  }

  /// All labels in the order of `add`.
  std::span<TimerEntry const> entries() const { return entries_; }

 private:
  std::vector<TimerEntry> entries_;
};

/// Times its own lifetime: `{ ScopedTimer const timing(timers, id); work(); }`.
class ScopedTimer {
 public:
  ScopedTimer(Timers& timers, int id) : timers_(timers), id_(id), start_(Timers::Clock::now()) {}
  ~ScopedTimer() { timers_.record(id_, Timers::Clock::now() - start_); }
  ScopedTimer(ScopedTimer const&) = delete;
  ScopedTimer& operator=(ScopedTimer const&) = delete;

 private:
  Timers& timers_;
  int id_;
  Timers::Clock::time_point start_;
};

}  // namespace moraine
