#include "blast/oblique_shock.hpp"

#include <algorithm>
#include <cmath>

#include "blast/scales.hpp"

namespace moraine::blast {

double normal_mach_squared(double pressure_ratio) { return (6.0 * pressure_ratio + 1.0) / 7.0; }

double strongest_ratio(double mach_squared) { return (7.0 * mach_squared - 1.0) / 6.0; }

double deflection(double pressure_ratio, double mach_squared) {
  double const along = std::max(0.0, mach_squared / normal_mach_squared(pressure_ratio) - 1.0);
  return std::atan((pressure_ratio - 1.0) /
                   (1.0 + heat_capacity_ratio * mach_squared - pressure_ratio) * std::sqrt(along));
}

double mach_squared_behind(double pressure_ratio, double mach_squared) {
  double const eta = pressure_ratio;
  return (mach_squared * (6.0 * eta + 1.0) - 5.0 * (eta * eta - 1.0)) / (eta * (eta + 6.0));
}

double detachment_ratio(double mach_squared) {
  double const g = heat_capacity_ratio, m = mach_squared;
  // NACA 1135, eq. (168): M^2 sin^2 of the shock angle at the greatest deflection.
  double const root = std::sqrt((g + 1.0) * (1.0 + 0.5 * (g - 1.0) * m + (g + 1.0) / 16.0 * m * m));
  double const normal = (0.25 * (g + 1.0) * m - 1.0 + root) / g;
  return strongest_ratio(normal);
}

}  // namespace moraine::blast
