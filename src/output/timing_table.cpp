#include "output/timing_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace moraine {

std::string timing_table(Timers const& timers, double wall_seconds) {
  std::vector<TimerEntry> rows(timers.entries().begin(), timers.entries().end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](TimerEntry const& a, TimerEntry const& b) { return a.total > b.total; });
  std::size_t width = 5;
  double covered = 0.0;
  for (TimerEntry const& row : rows) {
    width = std::max(width, row.label.size());
    covered += row.seconds();
  }
  double const to_percent = wall_seconds > 0.0 ? 100.0 / wall_seconds : 0.0;

  std::string table =
      fmt::format("{:<{}}  {:>10}  {:>6}  {:>10}\n", "label", width, "seconds", "%", "calls");
  for (TimerEntry const& row : rows)
    fmt::format_to(std::back_inserter(table), "{:<{}}  {:>10.3f}  {:>6.1f}  {:>10}\n", row.label,
                   width, row.seconds(), row.seconds() * to_percent, row.calls);
  double const other = wall_seconds - covered;
  if (other >= 0.0)
    fmt::format_to(std::back_inserter(table), "{:<{}}  {:>10.3f}  {:>6.1f}\n", "other", width,
                   other, other * to_percent);
  fmt::format_to(std::back_inserter(table), "{:<{}}  {:>10.3f}  {:>6.1f}\n", "total", width,
                 wall_seconds, wall_seconds * to_percent);
  return table;
}

}  // namespace moraine
