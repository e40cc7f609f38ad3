// Ranges in the variables that relations use.
#pragma once

#include <limits>

#include "blast/kingery_bulmash.hpp"
#include "blast/relation.hpp"

namespace moraine::blast {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

inline constexpr Validity everywhere{.known = Validity::Known::everywhere};
inline constexpr Validity unstated{.known = Validity::Known::unstated};

constexpr Validity range_of(std::string_view variable, std::string_view unit,
                            double (*of)(Situation const&), double low, double high) {
  return {Validity::Known::range, variable, unit, of, low, high};
}

/// Z = R/W^(1/3).
constexpr Validity scaled_metric(double low, double high) {
  return range_of(
      "R/W^(1/3)", "m/kg^(1/3)", [](Situation const& s) { return s.scaled_distance(); }, low, high);
}
constexpr Validity scaled_imperial(double low, double high) {
  return range_of(
      "R/W^(1/3)", "ft/lb^(1/3)", [](Situation const& s) { return s.scaled_distance_imperial(); },
      low, high);
}
constexpr Validity scaled_imperial(ScaledRange const& range) {
  return scaled_imperial(range.low / foot_per_pound, range.high / foot_per_pound);
}

}  // namespace moraine::blast
