#include "blast/bubble.hpp"

#include <cmath>
#include <numbers>

namespace moraine::blast {

double bubble_radius(double charge_mass, double depth) {
  return 3.50 * std::cbrt(charge_mass / (depth + 10.0));
}

double bubble_period(double charge_mass, double depth) {
  return 2.11 * std::cbrt(charge_mass) * std::pow(depth + 10.0, -5.0 / 6.0);
}

double bubble_energy(double radius, double water_pressure) {
  return 4.0 * std::numbers::pi / 3.0 * water_pressure * radius * radius * radius;
}

double rayleigh_period(double radius, double density, double water_pressure) {
  return 1.83 * radius * std::sqrt(density / water_pressure);
}

double willis_period(double energy, double density, double water_pressure) {
  return 1.14 * std::sqrt(density) * std::cbrt(energy) * std::pow(water_pressure, -5.0 / 6.0);
}

}  // namespace moraine::blast
