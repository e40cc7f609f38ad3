#include "blast/front.hpp"

#include <cmath>

#include "blast/scales.hpp"

namespace moraine::blast {

double Air::sound_speed() const { return std::sqrt(heat_capacity_ratio * pressure / density); }

double front_speed(double overpressure, Air const& air) {
  return air.sound_speed() * std::sqrt(1.0 + 6.0 * overpressure / (7.0 * air.pressure));
}

double particle_speed(double overpressure, Air const& air) {
  double const ratio = overpressure / (7.0 * air.pressure);
  return air.sound_speed() * 5.0 * ratio / std::sqrt(1.0 + 6.0 * ratio);
}

double dynamic_pressure(double overpressure, Air const& air) {
  return 2.5 * overpressure * overpressure / (7.0 * air.pressure + overpressure);
}

double normal_reflection(double overpressure, double ambient_pressure) {
  return 2.0 * overpressure * (7.0 * ambient_pressure + 4.0 * overpressure) /
         (7.0 * ambient_pressure + overpressure);
}

}  // namespace moraine::blast
