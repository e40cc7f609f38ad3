#include "watch/spark_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace moraine::watch {
namespace {

constexpr std::array<std::string_view, 8> blocks{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The value of a piece that is farthest from `mean`.
double most_telling(std::span<double const> piece, double mean) {
  double found = none;
  for (double const value : piece)
    if (std::isfinite(value) &&
        (std::isnan(found) || std::abs(value - mean) > std::abs(found - mean)))
      found = value;
  return found;
}

}  // namespace

std::string spark_line(std::span<double const> values, std::size_t width) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double sum = 0.0, count = 0.0;
  for (double const value : values)
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
      sum += value;
      ++count;
    }
  std::string line;
  std::size_t const pieces = std::min(width, values.size());
  for (std::size_t i = 0; i < pieces; ++i) {
    std::size_t const first = i * values.size() / pieces;
    std::size_t const last = (i + 1) * values.size() / pieces;
    double const value = most_telling(values.subspan(first, last - first), sum / count);
    double const share = high > low ? (value - low) / (high - low) : 0.0;
    if (std::isnan(value))
      line += ' ';
    else
      line += blocks[static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * 7.0))];
  }
  return line;
}

}  // namespace moraine::watch
