#include "sweep/sweep_progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace moraine {
namespace {

constexpr double redraw_interval = 0.5;  // s

std::string counts_of(SweepCount const& count) {
  std::string text = fmt::format("{} of {} done", count.done, count.total);
  if (count.failed > 0) text += fmt::format(", {} failed", count.failed);
  if (!count.running.empty()) text += fmt::format(", {} running", count.running.size());
  return text;
}

}  // namespace

SweepProgress::SweepProgress(ProgressSink sink) : sink_(std::move(sink)) {}

void SweepProgress::learn(double seconds) {
  learnt_ += seconds;
  ++members_;
}

std::string SweepProgress::line(SweepCount const& count) const {
  std::string text = counts_of(count);
  std::size_t const left = count.total - count.done - count.failed;
  if (members_ == 0 || left == 0) return text;
  double const each = learnt_ / static_cast<double>(members_);
  double work = each * static_cast<double>(left);
  for (double const seconds : count.running) work -= std::min(seconds, each);
  auto const lanes = std::min(std::max<std::size_t>(1, count.at_once), left);
  return text + fmt::format(", ETA {}", duration(work / static_cast<double>(lanes)));
}

void SweepProgress::update(SweepCount const& count) {
  std::string const counts = counts_of(count);
  bool const changed = counts != counts_;
  if (!changed && (!sink_.terminal || now() - shown_at_ < redraw_interval)) return;
  counts_ = counts;
  shown_at_ = now();
  if (sink_.terminal) {
    *sink_.stream << "\r\x1b[2K" << line(count).substr(0, sink_.columns - 1) << std::flush;
    line_open_ = true;
  } else {
    *sink_.stream << line(count) << '\n' << std::flush;
  }
}

void SweepProgress::say(std::string const& text) {
  clear();
  *sink_.stream << text << '\n' << std::flush;
}

void SweepProgress::clear() {
  if (line_open_) *sink_.stream << "\r\x1b[2K";
  line_open_ = false;
}

void SweepProgress::finish() {
  if (line_open_) *sink_.stream << '\n' << std::flush;
  line_open_ = false;
}

}  // namespace moraine
