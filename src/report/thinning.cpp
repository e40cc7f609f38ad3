#include "report/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace moraine::report {
namespace {

constexpr std::size_t most_rows = 4000;   // a line on a large screen has no more points
constexpr std::size_t enough_rows = 300;  // columns are not left out for more
constexpr double time_bytes = 8.0 * 4.0 / 3.0;
constexpr double table_bytes = 400.0;  // what describes it

struct Extremes {
  std::size_t lowest = 0, highest = 0;  // rows
  double range = 0.0;                   // 0: constant, or no numbers
};

Extremes extremes_of(std::vector<double> const& values) {
  Extremes found;
  bool any = false;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!std::isfinite(values[row])) continue;
    if (!any || values[row] < values[found.lowest]) found.lowest = row;
    if (!any || values[row] > values[found.highest]) found.highest = row;
    any = true;
  }
  if (any) found.range = values[found.highest] - values[found.lowest];
  return found;
}

/// Those of the columns that are shown.
struct Seen {
  std::vector<double> const* values;
  Extremes extremes;
};

/// How far a row is from the chord of its piece, summed over the columns by their ranges.
double distance(std::vector<Seen> const& columns, std::size_t first, std::size_t last,
                std::size_t row) {
  double const share = static_cast<double>(row - first) /
                       static_cast<double>(std::max<std::size_t>(last - first, 1));
  double sum = 0.0;
  for (Seen const& column : columns) {
    auto const& values = *column.values;
    double const chord = values[first] + share * (values[last] - values[first]);
    double const off = std::abs(values[row] - chord);
    if (column.extremes.range > 0.0 && std::isfinite(off)) sum += off / column.extremes.range;
  }
  return sum;
}

/// The row of a piece that stands out most; its first where none does.
std::size_t outstanding(std::vector<Seen> const& columns, std::size_t first, std::size_t last) {
  std::size_t found = first;
  double largest = 0.0;
  for (std::size_t row = first + 1; row < last; ++row) {
    double const off = distance(columns, first, last, row);
    if (off <= largest) continue;
    largest = off;
    found = row;
  }
  return found;
}

std::vector<std::size_t> numbers_to(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

/// "P" of "P[3]": the points of a line.
std::string line_of(std::string const& gauge) {
  return gauge.ends_with(']') ? gauge.substr(0, gauge.rfind('[')) : gauge;
}

}  // namespace

std::string gauge_of(std::string const& label) {
  std::size_t const space = label.rfind(' ');
  return space == std::string::npos ? "" : label.substr(0, space);
}

TablePart part_that_fits(TablePart const& whole, TableCost const& cost, std::size_t bytes) {
  double const room = static_cast<double>(bytes) - table_bytes;
  auto const least = static_cast<double>(std::min(whole.rows, enough_rows));
  double const fit = (room - least * time_bytes) / (cost.column + least * cost.number);
  auto const columns = static_cast<double>(whole.columns);
  if (!(fit >= 1.0)) return {};
  if (fit < columns) return {static_cast<std::size_t>(fit), static_cast<std::size_t>(least)};
  double const rows = (room - columns * cost.column) / (columns * cost.number + time_bytes);
  return {whole.columns,
          std::min({whole.rows, most_rows, static_cast<std::size_t>(std::max(rows, least))})};
}

std::vector<std::size_t> shown_columns(Table const& table, std::size_t most,
                                       std::set<std::string> const& wanted) {
  struct Place {
    bool later;            // not among the wanted
    std::size_t in_gauge;  // the how manieth of its gauge
    std::size_t column;
  };
  std::map<std::string, std::size_t> met;
  std::vector<Place> places;
  for (std::size_t k = 1; k < table.columns.size(); ++k) {
    std::string const& label = table.columns[k].name;
    places.push_back({!wanted.contains(label), met[line_of(gauge_of(label))]++, k});
  }
  std::stable_sort(places.begin(), places.end(), [](Place const& a, Place const& b) {
    return a.later != b.later ? b.later : a.in_gauge < b.in_gauge;
  });
  places.resize(std::min(most, places.size()));
  std::vector<std::size_t> columns;
  for (Place const& place : places) columns.push_back(place.column);
  std::sort(columns.begin(), columns.end());
  return columns;
}

std::vector<std::size_t> shown_rows(Table const& table, std::vector<std::size_t> const& columns,
                                    std::size_t most) {
  std::size_t const rows = table.rows();
  if (rows <= most) return numbers_to(rows);
  std::vector<Seen> seen;
  for (std::size_t const k : columns) seen.push_back({&table.values[k], {}});
  for (Seen& column : seen) column.extremes = extremes_of(*column.values);
  std::vector<std::size_t> shown;
  for (Seen const& column : seen)
    if (2 * (shown.size() + 2) <= most)
      shown.insert(shown.end(), {column.extremes.lowest, column.extremes.highest});
  // Two rows of each piece, and the end of the last.
  std::size_t const pieces =
      most > shown.size() + 1 ? std::max<std::size_t>((most - shown.size() - 1) / 2, 1) : 1;
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    std::size_t const first = piece * (rows - 1) / pieces;
    std::size_t const last = (piece + 1) * (rows - 1) / pieces;
    shown.insert(shown.end(), {first, outstanding(seen, first, last)});
  }
  shown.push_back(rows - 1);
  std::sort(shown.begin(), shown.end());
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  return shown;
}

}  // namespace moraine::report
