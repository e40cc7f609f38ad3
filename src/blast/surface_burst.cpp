#include "blast/surface_burst.hpp"

#include <cmath>

#include "blast/scales.hpp"

namespace moraine::blast {

double surface_impulse(double charge_mass, double distance, double k) {
  double const w = std::cbrt(charge_mass / pound);
  return psi * k * w * w / (distance / foot);
}

double contact_impulse(double charge_mass, double side_a, double side_b, double height) {
  double const slenderness = std::sqrt(side_a * side_b) / height;
  return pound_force * (charge_mass / pound) * (183.0 - 191.0 / (1.1 + slenderness));
}

}  // namespace moraine::blast
