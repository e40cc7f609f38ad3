#include "exact/taylor_green.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace moraine {

void TaylorGreen::check() const {
  if (!(length > 0.0 && density > 0.0))
    throw std::invalid_argument("Taylor-Green: length and density must be positive");
  if (!(kinematic_viscosity >= 0.0))
    throw std::invalid_argument("Taylor-Green: the viscosity must not be negative");
}

double TaylorGreen::wave_number() const { return 2.0 * std::numbers::pi / length; }

double TaylorGreen::decay_rate() const {
  return 2.0 * kinematic_viscosity * wave_number() * wave_number();
}

TaylorGreen::Sample TaylorGreen::sample(double x, double y, double time) const {
  double const k = wave_number();
  double const u = speed * std::exp(-decay_rate() * time);
  return {-u * std::cos(k * x) * std::sin(k * y), u * std::sin(k * x) * std::cos(k * y),
          -0.25 * density * u * u * (std::cos(2.0 * k * x) + std::cos(2.0 * k * y))};
}

double TaylorGreen::mean_energy(double time) const {
  double const u = speed * std::exp(-decay_rate() * time);
  return 0.25 * density * u * u;
}

}  // namespace moraine
