#include "report/quantised.hpp"

#include <algorithm>
#include <cmath>

namespace moraine::report {

void Interval::include(double value) {
  if (!std::isfinite(value)) return;
  min_ = any_ ? std::min(min_, value) : value;
  max_ = any_ ? std::max(max_, value) : value;
  any_ = true;
}

std::vector<std::uint16_t> quantised(std::span<double const> values, Interval const& interval) {
  // Halves, so that the length of an interval from -1e308 to 1e308 is a number.
  double const length = 0.5 * interval.max() - 0.5 * interval.min();
  std::vector<std::uint16_t> out;
  out.reserve(values.size());
  for (double const value : values) {
    if (!std::isfinite(value)) {
      out.push_back(65535);
      continue;
    }
    double const share = length > 0.0 ? (0.5 * value - 0.5 * interval.min()) / length : 0.0;
    out.push_back(
        static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * steps_of_16_bits)));
  }
  return out;
}

}  // namespace moraine::report
