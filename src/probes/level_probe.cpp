#include "probes/level_probe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/bisect.hpp"
#include "probes/filled_share.hpp"

namespace moraine {
namespace {

constexpr double least_filling = 0.1;  // below it there is no fluid on the line

}  // namespace

double probe_level(ParticleStore const& store, Search const& search, KernelName kernel, double h,
                   Line const& line) {
  Vec3 const along = subtract(line.to, line.from);
  double const length = norm(along);
  Vec3 const direction = scale(1.0 / length, along);
  auto const share = [&](double s) {
    return filled_share(store, search, kernel, h, add(line.from, scale(s, direction)),
                        [](std::size_t) { return true; });
  };
  auto const steps = static_cast<std::size_t>(std::ceil(length / (0.25 * h)));
  double const step = length / static_cast<double>(steps);
  std::vector<double> filled;
  for (std::size_t k = 0; k <= steps; ++k) filled.push_back(share(step * static_cast<double>(k)));
  double const largest = *std::max_element(filled.begin(), filled.end());
  if (!(largest >= least_filling)) return std::numeric_limits<double>::quiet_NaN();
  double const threshold = 0.5 * std::min(1.0, largest);
  std::size_t last = steps;
  while (filled[last] < threshold) --last;
  double const start = dot(line.from, direction);
  if (last == steps) return start + length;
  double const low = step * static_cast<double>(last);
  return start + bisect([&](double s) { return share(s) - threshold; }, low, low + step);
}

}  // namespace moraine
