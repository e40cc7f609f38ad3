#include "watch/screen.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "output/printable.hpp"
#include "output/progress.hpp"
#include "output/si_prefix.hpp"
#include "watch/spark_line.hpp"

namespace moraine::watch {
namespace {

using report::number_at;
using report::RunFiles;
using report::text_at;

constexpr std::size_t bar_width = 30;

/// The first `most` characters, counted as code points.
std::string cut(std::string const& text, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U && count++ == most)
      return text.substr(0, i);
  return text;
}

/// Filled up with blanks, or cut, to a number of characters.
std::string fitted(std::string const& text, std::size_t width) {
  std::string out = cut(text, width);
  auto const count = static_cast<std::size_t>(std::count_if(out.begin(), out.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
  return out + std::string(width - count, ' ');
}

std::string way(RunFiles const& run) {
  double const time = number_at(run.status, "time_s").value_or(0.0);
  double const end = number_at(run.status, "end_time_s").value_or(0.0);
  double const share = end > 0.0 ? std::clamp(time / end, 0.0, 1.0) : 0.0;
  auto const filled = static_cast<std::size_t>(share * bar_width);
  std::string line = fmt::format("[{}{}] {:.0f} %  {} of {}", std::string(filled, '#'),
                                 std::string(bar_width - filled, '.'), 100.0 * share,
                                 with_unit(time, "s", 4), with_unit(end, "s", 4));
  if (auto const left = number_at(run.status, "time_left_s"); left && state_of(run) == "running")
    line += fmt::format("  {} left", duration(*left));
  return line;
}

std::string pace(RunFiles const& run) {
  std::string line = fmt::format("step {:.0f}", number_at(run.status, "step").value_or(0.0));
  if (auto const rate = number_at(run.status, "steps_per_second"))
    line += fmt::format("  {:.3g} steps/s", *rate);
  return line + fmt::format("  {:.0f} particles  {} of computing",
                            number_at(run.status, "particles").value_or(0.0),
                            duration(number_at(run.status, "wall_time_s").value_or(0.0)));
}

std::string limits(RunFiles const& run) {
  auto const step = number_at(run.status, "time_step_s");
  std::string line = fmt::format("time step {}, limited by {}", step ? with_unit(*step, "s") : "-",
                                 text_at(run.status, "limited_by"));
  if (run.status.contains("votes") && run.status["votes"].is_array() &&
      !run.status["votes"].empty()) {
    auto const& first = run.status["votes"][0];
    line += fmt::format("; most often by {} ({:.0f} steps)", text_at(first, "reason"),
                        number_at(first, "steps").value_or(0.0));
  }
  return line;
}

std::string guards(RunFiles const& run) {
  std::string line;
  if (run.status.contains("guards") && run.status["guards"].is_array())
    for (auto const& guard : run.status["guards"])
      line += fmt::format("{}{} {:.2g} %", line.empty() ? "guards: " : ", ", text_at(guard, "name"),
                          100.0 * number_at(guard, "largest_part_of_bound").value_or(0.0));
  return line;
}

std::string last_number(std::vector<double> const& values, std::string const& unit) {
  return std::isfinite(values.back()) ? with_unit(values.back(), unit) : "-";
}

/// One line: name, last value, small plot.
std::string curve(TableColumn const& column, std::vector<double> const& values,
                  std::size_t columns) {
  constexpr std::size_t name_width = 34, value_width = 13;
  std::size_t const width =
      columns > name_width + value_width + 2 ? columns - name_width - value_width - 2 : 10;
  return fitted(column.name, name_width) + ' ' +
         fitted(last_number(values, column.unit), value_width) + ' ' + spark_line(values, width);
}

void add_curves(std::vector<std::string>& lines, Table const& table, ScreenSize const& size) {
  if (table.rows() == 0) return;
  for (std::size_t k = 1; k < table.columns.size() && lines.size() + 1 < size.rows; ++k)
    lines.push_back(curve(table.columns[k], table.values[k], size.columns));
}

}  // namespace

std::string screen_of(RunFiles const& run, ScreenSize const& size) {
  std::string const title =
      run.used_case && !run.used_case->title.empty() ? run.used_case->title : run.name;
  std::vector<std::string> lines{fmt::format("{}  ({})", title, state_of(run)), way(run), pace(run),
                                 limits(run), guards(run)};
  if (std::string const reason = report::end_reason(run); !reason.empty()) lines.push_back(reason);
  lines.emplace_back();
  // Energies tell of any run; leave them room below the gauges.
  ScreenSize gauges = size;
  gauges.rows = size.rows > 6 ? size.rows - 5 : size.rows;
  add_curves(lines, run.gauges, gauges);
  add_curves(lines, run.sums, size);
  std::string text;
  for (std::string const& line : lines) text += cut(printable(line), size.columns) + '\n';
  return text;
}

}  // namespace moraine::watch
