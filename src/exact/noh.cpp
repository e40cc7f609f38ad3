#include "exact/noh.hpp"

#include <cmath>
#include <stdexcept>

namespace moraine {

void Noh::check() const {
  if (!(heat_capacity_ratio > 1.0))
    throw std::invalid_argument("Noh: the heat capacity ratio must be above 1");
  if (!(density > 0.0 && speed > 0.0))
    throw std::invalid_argument("Noh: density and speed must be positive");
}

double Noh::shock_position(double time) const {
  return 0.5 * (heat_capacity_ratio - 1.0) * speed * time;
}

double Noh::stagnation_density() const {
  double const gamma = heat_capacity_ratio;
  return density * std::pow((gamma + 1.0) / (gamma - 1.0), dimensions(geometry));
}

FlowState Noh::sample(double r, double time) const {
  if (r < shock_position(time)) {
    double const rho = stagnation_density();
    double const e = 0.5 * speed * speed;
    return {rho, 0.0, (heat_capacity_ratio - 1.0) * rho * e, e};
  }
  // Where nothing has moved yet the limit is the initial density, also at the origin.
  double const crowding = time > 0.0 ? 1.0 + speed * time / r : 1.0;
  return {density * std::pow(crowding, dimensions(geometry) - 1), -speed, 0.0, 0.0};
}

}  // namespace moraine
