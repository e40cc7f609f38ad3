#include "report/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moraine::report {
namespace {

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

/// How far a row is from the chord of its piece, summed over the columns by their ranges.
double distance(Table const& table, std::vector<Extremes> const& extremes, std::size_t first,
                std::size_t last, std::size_t row) {
  double const share = static_cast<double>(row - first) /
                       static_cast<double>(std::max<std::size_t>(last - first, 1));
  double sum = 0.0;
  for (std::size_t k = 1; k < table.values.size(); ++k) {
    auto const& values = table.values[k];
    double const chord = values[first] + share * (values[last] - values[first]);
    double const off = std::abs(values[row] - chord);
    if (extremes[k].range > 0.0 && std::isfinite(off)) sum += off / extremes[k].range;
  }
  return sum;
}

}  // namespace

std::vector<std::size_t> shown_rows(Table const& table, std::size_t most) {
  std::size_t const rows = table.rows();
  std::vector<std::size_t> shown;
  if (rows <= most) {
    shown.resize(rows);
    std::iota(shown.begin(), shown.end(), std::size_t{0});
    return shown;
  }
  std::vector<Extremes> extremes;
  for (auto const& values : table.values) extremes.push_back(extremes_of(values));
  for (Extremes const& e : extremes) shown.insert(shown.end(), {e.lowest, e.highest});
  std::size_t const pieces = std::max<std::size_t>(most / 2, 2);
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    std::size_t const first = piece * (rows - 1) / pieces;
    std::size_t const last = (piece + 1) * (rows - 1) / pieces;
    shown.insert(shown.end(), {first, last});
    std::size_t outstanding = first;
    double largest = 0.0;
    for (std::size_t row = first + 1; row < last; ++row) {
      double const off = distance(table, extremes, first, last, row);
      if (off > largest) {
        largest = off;
        outstanding = row;
      }
    }
    shown.push_back(outstanding);
  }
  std::sort(shown.begin(), shown.end());
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  return shown;
}

}  // namespace moraine::report
