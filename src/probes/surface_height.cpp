#include "probes/surface_height.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "probes/filled_share.hpp"

namespace moraine {
namespace {

constexpr double least_filling = 0.1;  // below it there is nothing
constexpr int stretch = 16;            // steps of h / 4 that are looked at below the first filled
constexpr int halvings = 16;           // of a step: to 4e-6 h

}  // namespace

double surface_height(BodyView const& view, Vec3 const& place, double top, double bottom) {
  double const step = 0.25 * view.h;
  auto const share = [&](double height) {
    return filled_share(view.store, view.search, view.kernel, view.h, view.up.at(place, height),
                        [&](std::size_t i) { return view.members[i] != 0; });
  };
  auto const height_at = [&](int k) { return top - step * k; };
  int first = 0;
  double filling = share(top);
  while (filling < least_filling) {
    if (height_at(++first) < bottom) return std::numeric_limits<double>::quiet_NaN();
    filling = share(height_at(first));
  }
  std::vector<double> filled{filling};
  for (int k = 1; k <= stretch; ++k) filled.push_back(share(height_at(first + k)));
  double const threshold = 0.5 * std::min(1.0, *std::max_element(filled.begin(), filled.end()));
  int k = 0;
  while (filled[static_cast<std::size_t>(k)] < threshold) ++k;
  if (first + k == 0) return top;
  double low = height_at(first + k);
  double high = height_at(first + k - 1);
  for (int halving = 0; halving < halvings; ++halving) {
    double const middle = 0.5 * (low + high);
    (share(middle) < threshold ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

HeightRange heights_of(BodyView const& view) {
  HeightRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < view.members.size(); ++i) {
    if (view.members[i] == 0) continue;
    double const height = view.up.height(particle_place(view.store, i));
    range.low = std::min(range.low, height);
    range.high = std::max(range.high, height);
  }
  return range;
}

}  // namespace moraine
