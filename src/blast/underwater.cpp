#include "blast/underwater.hpp"

#include <algorithm>
#include <cmath>

#include "blast/crater.hpp"
#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

constexpr double water_sound_speed = 1500.0;  // m/s, of Zamyshlyaev's time constant

}  // namespace

double penney_pressure(double scaled_distance) {
  double const x = foot_per_pound / scaled_distance;
  return psi * 14100.0 * x * std::exp(0.27 * x);
}

double kirkwood_brinkley_pressure(double scaled_distance) {
  double const z = scaled_distance / foot_per_pound;
  return psi * 22150.0 / (z * std::sqrt(std::log10(z) + 0.873));
}

double cole_pressure(double scaled_distance) { return 52.4e6 * std::pow(scaled_distance, -1.13); }

double inverse_distance_water_impulse(double scaled_distance) {
  return psi * 2.11 / cube_root_of_pound * (foot_per_pound / scaled_distance);
}

double swisdak_water_pressure(double scaled_distance) {
  return 52.16e6 * std::pow(scaled_distance, -1.13);
}

double swisdak_water_time_constant(double scaled_distance) {
  return 96.5e-6 * std::pow(scaled_distance, 0.22);
}

double swisdak_water_impulse(double scaled_distance) {
  return 5750.0 * std::pow(scaled_distance, -0.89);
}

double swisdak_water_energy(double scaled_distance) {
  return 84400.0 * std::pow(scaled_distance, -2.04);
}

double zamyshlyaev_pressure(double scaled_distance) {
  if (charge_radii(scaled_distance) < 12.0) return 44.1e6 * std::pow(scaled_distance, -1.5);
  return 52.4e6 * std::pow(scaled_distance, -1.13);
}

double zamyshlyaev_time_constant(double scaled_distance) {
  double const radius = charge_radius(1.0), r = charge_radii(scaled_distance);
  if (r < 30.0) return 0.45e-3 * radius * std::pow(r, 0.45);
  return 3.5 * radius / water_sound_speed * std::sqrt(std::log10(r) - 0.9);
}

double charge_radii(double scaled_distance) { return scaled_distance / charge_radius(1.0); }

double energy_lost(double scaled_distance) {
  double const r = std::clamp(charge_radii(scaled_distance), 5.0, 25.0);
  return 0.30 + 0.18 * std::log(r / 5.0) / std::log(5.0);
}

}  // namespace moraine::blast
