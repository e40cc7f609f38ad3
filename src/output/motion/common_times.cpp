#include "output/motion/common_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/gravity.hpp"

namespace moraine {

std::vector<double> common_times(std::vector<GroundRecord> const& records) {
  constexpr double most = 200'000.0;
  double start = std::numeric_limits<double>::infinity(), end = -start, step = start;
  for (GroundRecord const& record : records) {
    start = std::min(start, record.start);
    end = std::max(end, record.time(record.size() - 1));
    step = std::min(step, record.time_step);
  }
  double const count = std::min(most, std::floor((end - start) / step + 1e-6) + 1.0);
  step = std::max(step, (end - start) / most);
  std::vector<double> times(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = start + static_cast<double>(i) * step;
  return times;
}

std::vector<double> in_g(std::vector<double> accelerations) {
  for (double& a : accelerations) a /= standard_gravity;
  return accelerations;
}

std::vector<double> at_times(GroundRecord const& record, std::vector<double> const& history,
                             std::vector<double> const& times) {
  std::vector<double> values(times.size(), std::numeric_limits<double>::quiet_NaN());
  auto const last = static_cast<double>(history.size() - 1);
  for (std::size_t i = 0; i < times.size(); ++i) {
    double const place = (times[i] - record.start) / record.time_step;
    if (place < -1e-6 || place > last + 1e-6) continue;
    double const inside = std::clamp(place, 0.0, last);
    auto const k = std::min(history.size() - 2, static_cast<std::size_t>(inside));
    values[i] = history[k] + (inside - static_cast<double>(k)) * (history[k + 1] - history[k]);
  }
  return values;
}

}  // namespace moraine
