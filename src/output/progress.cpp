#include "output/progress.hpp"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <utility>

#include "output/si_prefix.hpp"

namespace moraine {
namespace {

constexpr double redraw_interval = 0.1;   // s, on a terminal
constexpr double line_interval = 5.0;     // s, elsewhere
constexpr double averaging_time = 3.0;    // s, of the rates
constexpr double shortest_sample = 0.05;  // s, below which a rate is mostly noise
constexpr std::size_t bar_width = 20;     // characters

/// The longest beginning of UTF-8 text with at most `columns` characters.
std::string_view cut(std::string_view text, std::size_t columns) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool const starts_character = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (starts_character && count++ == columns) return text.substr(0, i);
  }
  return text;
}

}  // namespace

std::string duration(double seconds) {
  if (!std::isfinite(seconds) || seconds > 1e8) return "-";
  auto const total = static_cast<long>(std::ceil(seconds - 1e-3));  // less than rounding noise
  long const hours = total / 3600, minutes = total / 60 % 60;
  if (hours >= 48) return fmt::format("{} d {} h", hours / 24, hours % 24);
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, total % 60);
  return fmt::format("{}:{:02}", minutes, total % 60);
}

ProgressSink standard_progress_sink() {
  auto const seconds = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  winsize size{};
  bool const terminal = isatty(STDERR_FILENO) == 1;
  bool const known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return {&std::cerr, seconds, terminal, known ? size.ws_col : std::size_t{80}};
}

Progress::Progress(ProgressSink sink) : sink_(std::move(sink)) {}

Progress::~Progress() { finish(); }

double Progress::fraction(double time, double end_time) const {
  double const way = end_time - first_->time;
  return way > 0.0 ? std::clamp((time - first_->time) / way, 0.0, 1.0) : 1.0;
}

bool Progress::due(double now, double fraction) const {
  if (sink_.terminal) return now - shown_at_ >= redraw_interval;
  return now - shown_at_ >= line_interval || static_cast<int>(fraction * 10.0) > shown_tenth_;
}

void Progress::measure(double now, ProgressReport const& report) {
  double const elapsed = now - previous_.clock;
  if (elapsed < shortest_sample) return;
  Rates const latest{(report.time - previous_.time) / elapsed,
                     static_cast<double>(report.step - previous_.step) / elapsed};
  if (!rates_) {
    rates_ = latest;
  } else {
    double const weight = 1.0 - std::exp(-elapsed / averaging_time);
    rates_->simulated_per_second +=
        weight * (latest.simulated_per_second - rates_->simulated_per_second);
    rates_->steps_per_second += weight * (latest.steps_per_second - rates_->steps_per_second);
  }
  previous_ = {now, report.time, report.step};
}

void Progress::update(ProgressReport const& report) {
  if (finished_) return;
  double const now = sink_.clock();
  last_ = report;
  if (!first_) {
    first_ = previous_ = {now, report.time, report.step};
    shown_at_ = now;
  }
  double const done = fraction(report.time, report.end_time);
  if (due(now, done)) {
    limited_by_ = report.limited_by;
    measure(now, report);
    show();
    shown_at_ = now;
    shown_tenth_ = static_cast<int>(done * 10.0);
  }
  // The text behind the view may be gone when finish() shows the last state.
  last_.limited_by = {};
}

std::string Progress::bar(double fraction) const {
  auto const eighths =
      static_cast<std::size_t>(std::lround(fraction * static_cast<double>(bar_width * 8)));
  constexpr std::string_view parts[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};
  std::string text = "▕";
  for (std::size_t i = 0; i < eighths / 8; ++i) text += "█";
  text += parts[eighths % 8];
  std::size_t const used = eighths / 8 + (eighths % 8 > 0 ? 1 : 0);
  text.append(bar_width - used, ' ');
  return text + "▏";
}

std::string Progress::line() const {
  double const done = fraction(last_.time, last_.end_time);
  std::string text = sink_.terminal ? bar(done) : std::string();
  text += fmt::format("{:3.0f} %  t = {}  step {}", std::floor(done * 100.0),
                      with_unit(last_.time, "s", 4), last_.step);
  if (rates_) {
    double const updates = rates_->steps_per_second * static_cast<double>(last_.particles);
    double const left = (last_.end_time - last_.time) / rates_->simulated_per_second;
    text += fmt::format("  {} steps/s  {} updates/s", with_prefix(rates_->steps_per_second),
                        with_prefix(updates));
    if (done < 1.0) text += fmt::format("  ETA {}", duration(left));
  }
  text += fmt::format("  Δt = {}", with_unit(last_.time_step, "s"));
  if (!limited_by_.empty()) text += fmt::format(" ({})", limited_by_);
  return text;
}

void Progress::show() {
  std::string const text = line();
  if (sink_.terminal) {
    // Carriage return and "erase line"; the last column stays free so that nothing wraps.
    *sink_.stream << "\r\x1b[2K" << cut(text, sink_.columns - 1) << std::flush;
    line_open_ = true;
  } else {
    *sink_.stream << text << '\n' << std::flush;
  }
}

void Progress::clear() {
  if (!line_open_) return;
  *sink_.stream << "\r\x1b[2K" << std::flush;
  line_open_ = false;
}

void Progress::finish() {
  if (finished_) return;
  finished_ = true;
  if (!first_) return;
  if (sink_.terminal || fraction(last_.time, last_.end_time) * 10.0 > shown_tenth_) {
    measure(sink_.clock(), last_);
    show();
  }
  if (line_open_) *sink_.stream << '\n' << std::flush;
  line_open_ = false;
}

}  // namespace moraine
