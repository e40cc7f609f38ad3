#include "probes/decay_fit.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace moraine {
namespace {

double mean(std::vector<double> const& values) {
  double sum = 0.0;
  for (double const value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

bool is_positive(double value) { return value > 0.0 && std::isfinite(value); }

}  // namespace

DecayFit fit_decay(std::span<double const> distances, std::span<double const> values) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x, y;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    if (!is_positive(distances[k]) || !is_positive(values[k])) continue;
    x.push_back(std::log(distances[k]));
    y.push_back(std::log(values[k]));
  }
  DecayFit fit{nothing, nothing, x.size()};
  if (x.empty()) return fit;
  double const mean_x = mean(x);
  double const mean_y = mean(y);
  double xx = 0.0, xy = 0.0;
  bool spread = false;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mean_x) * (x[k] - mean_x);
    xy += (x[k] - mean_x) * (y[k] - mean_y);
    spread = spread || x[k] != x[0];
  }
  if (!spread) return fit;
  fit.exponent = xy / xx;
  double squares = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    double const off = y[k] - mean_y - fit.exponent * (x[k] - mean_x);
    squares += off * off;
  }
  fit.scatter = std::sqrt(squares / static_cast<double>(x.size()));
  return fit;
}

}  // namespace moraine
