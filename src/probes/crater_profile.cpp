#include "probes/crater_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace moraine {
namespace {

/// Where the profile passes a height between sample k - 1 and k, in steps.
double crossing(std::vector<double> const& height, std::size_t k, double level) {
  double const before = height[k - 1];
  double const share = (level - before) / (height[k] - before);
  return static_cast<double>(k - 1) + share;
}

/// The end of the crater in steps from the axis.
std::optional<double> find_end(CraterProfile const& profile, std::size_t deepest,
                               double tolerance) {
  auto const& z = profile.height;
  std::size_t k = deepest + 1;
  while (k < z.size() && z[k] < -tolerance) ++k;
  if (k >= z.size()) return std::nullopt;
  double const end = crossing(z, k, -tolerance);
  double const last = end + 8.0 * tolerance / profile.step;
  for (std::size_t m = k; m < z.size() && static_cast<double>(m - 1) < last; ++m)
    if (z[m] >= 0.0 && z[m - 1] < 0.0) return std::min(crossing(z, m, 0.0), last);
  return end;
}

/// Integral of depth (times distance) from the axis to `end` steps.
double content_to(CraterProfile const& profile, double end, bool round) {
  auto const& z = profile.height;
  auto const value = [&](double steps, double height) {
    return std::max(-height, 0.0) * (round ? steps * profile.step : 1.0);
  };
  double sum = 0.0;
  for (std::size_t k = 1; k < z.size(); ++k) {
    auto const from = static_cast<double>(k - 1);
    if (from >= end) break;
    double const to = std::min(static_cast<double>(k), end);
    double const height = z[k - 1] + (to - from) * (z[k] - z[k - 1]);
    sum += 0.5 * (to - from) * (value(from, z[k - 1]) + value(to, height));
  }
  return sum * profile.step;
}

}  // namespace

ProfileReading read_profile(CraterProfile const& profile, double tolerance, bool round) {
  auto const& z = profile.height;
  if (z.empty()) return {};
  auto const deepest = static_cast<std::size_t>(std::min_element(z.begin(), z.end()) - z.begin());
  ProfileReading reading;
  if (-z[deepest] <= tolerance) return reading;
  reading.depth = -z[deepest];
  auto const end = find_end(profile, deepest, tolerance);
  if (!end) {
    reading.content = content_to(profile, static_cast<double>(z.size()), round);
    reading.apparent_radius = reading.rim_radius = reading.rim_height =
        std::numeric_limits<double>::quiet_NaN();
    return reading;
  }
  reading.apparent_radius = reading.rim_radius = *end * profile.step;
  reading.content = content_to(profile, *end, round);
  for (auto k = static_cast<std::size_t>(std::ceil(*end));
       k < z.size() && static_cast<double>(k) <= 2.0 * *end; ++k)
    if (z[k] > std::max(tolerance, reading.rim_height)) {
      reading.rim_height = z[k];
      reading.rim_radius = static_cast<double>(k) * profile.step;
    }
  return reading;
}

}  // namespace moraine
