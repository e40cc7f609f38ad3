#include "exact/riemann_ideal_gas.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/bisect.hpp"

namespace moraine {
namespace {

double sound_speed(GasState const& gas, double gamma) {
  return std::sqrt(gamma * gas.pressure / gas.density);
}

// Velocity change across the wave between `gas` and pressure p: a shock for p > p_K, else a
// rarefaction. f_K of eqs. (4.6) to (4.8).
double velocity_change(GasState const& gas, double p, double gamma) {
  if (p > gas.pressure) {
    double const a = 2.0 / ((gamma + 1.0) * gas.density);
    double const b = (gamma - 1.0) / (gamma + 1.0) * gas.pressure;
    return (p - gas.pressure) * std::sqrt(a / (p + b));
  }
  double const power = (gamma - 1.0) / (2.0 * gamma);
  return 2.0 * sound_speed(gas, gamma) / (gamma - 1.0) * (std::pow(p / gas.pressure, power) - 1.0);
}

GasState behind_shock(GasState const& gas, double p, double u, double gamma) {
  double const ratio = p / gas.pressure;
  double const g = (gamma - 1.0) / (gamma + 1.0);
  return {gas.density * (ratio + g) / (g * ratio + 1.0), u, p};  // eq. (4.50)
}

// The state on the ray s in a left-hand wave system: everything left of the contact.
GasState left_of_contact(GasState const& gas, double p, double u, double gamma, double s) {
  double const c = sound_speed(gas, gamma);
  if (p > gas.pressure) {
    double const ratio = p / gas.pressure;
    double const mach =
        std::sqrt((gamma + 1.0) / (2.0 * gamma) * ratio + (gamma - 1.0) / (2.0 * gamma));
    return s < gas.velocity - c * mach ? gas : behind_shock(gas, p, u, gamma);  // eq. (4.52)
  }
  double const ratio = p / gas.pressure;
  double const c_star = c * std::pow(ratio, (gamma - 1.0) / (2.0 * gamma));  // eq. (4.54)
  if (s < gas.velocity - c) return gas;
  if (s >= u - c_star) return {gas.density * std::pow(ratio, 1.0 / gamma), u, p};  // eq. (4.53)
  double const c_fan =
      2.0 / (gamma + 1.0) * (c + 0.5 * (gamma - 1.0) * (gas.velocity - s));  // eq. (4.56)
  double const density = gas.density * std::pow(c_fan / c, 2.0 / (gamma - 1.0));
  return {density, s + c_fan, density * c_fan * c_fan / gamma};
}

GasState mirror(GasState const& gas) { return {gas.density, -gas.velocity, gas.pressure}; }

void check(GasState const& left, GasState const& right, double gamma) {
  if (!(gamma > 1.0))
    throw std::invalid_argument("Riemann problem: the heat capacity ratio must be above 1");
  for (GasState const& gas : {left, right})
    if (!(gas.density > 0.0 && gas.pressure > 0.0))
      throw std::invalid_argument("Riemann problem: density and pressure must be positive");
  double const fastest =
      2.0 * (sound_speed(left, gamma) + sound_speed(right, gamma)) / (gamma - 1.0);
  if (!(right.velocity - left.velocity < fastest))
    throw std::invalid_argument("Riemann problem: the states move apart and leave a vacuum");
}

}  // namespace

RiemannIdealGas::RiemannIdealGas(GasState const& left, GasState const& right,
                                 double heat_capacity_ratio)
    : gamma_(heat_capacity_ratio), left_(left), right_(right) {
  check(left, right, gamma_);
  // eq. (4.5); it rises with p from a negative value at p = 0, because there is no vacuum.
  auto const mismatch = [&](double p) {
    return velocity_change(left, p, gamma_) + velocity_change(right, p, gamma_) + right.velocity -
           left.velocity;
  };
  double high = std::max(left.pressure, right.pressure);
  while (mismatch(high) < 0.0) high *= 2.0;
  star_pressure_ = bisect(mismatch, 0.0, high);
  star_velocity_ =
      0.5 * (left.velocity + right.velocity + velocity_change(right, star_pressure_, gamma_) -
             velocity_change(left, star_pressure_, gamma_));  // eq. (4.9)
}

FlowState RiemannIdealGas::sample(double x_over_t) const {
  bool const on_left = x_over_t < star_velocity_;
  GasState const gas =
      on_left ? left_of_contact(left_, star_pressure_, star_velocity_, gamma_, x_over_t)
              : mirror(left_of_contact(mirror(right_), star_pressure_, -star_velocity_, gamma_,
                                       -x_over_t));
  return {gas.density, gas.velocity, gas.pressure, gas.pressure / ((gamma_ - 1.0) * gas.density)};
}

}  // namespace moraine
