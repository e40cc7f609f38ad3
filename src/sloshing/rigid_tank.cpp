#include "sloshing/rigid_tank.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace moraine {
namespace {

constexpr double pi = std::numbers::pi;

constexpr double steepest_ratio = 1e4;  // of length and depth, either way

/// (cosh x - c) / sinh x without overflow.
double floor_share(double x, double c) {
  double const e = std::exp(-x);
  return (1.0 + e * e - 2.0 * c * e) / (1.0 - e * e);
}

}  // namespace

void check_tank(RigidTank const& tank) {
  for (double const value : {tank.length, tank.depth, tank.width, tank.density, tank.gravity})
    if (!(value > 0.0) || !std::isfinite(value))
      throw std::invalid_argument(
          "rigid tank: length, depth, width, density and gravity must be positive");
  double const ratio = tank.length / tank.depth;
  if (!(ratio <= steepest_ratio * (1.0 + 1e-12) && ratio * steepest_ratio >= 1.0 - 1e-12))
    throw std::invalid_argument(fmt::format("rigid tank: length over depth must be {:g} to {:g}",
                                            1.0 / steepest_ratio, steepest_ratio));
}

double SloshingMode::frequency() const { return angular_frequency / (2.0 * pi); }

double SloshingMode::period() const { return 2.0 * pi / angular_frequency; }

SloshingMode sloshing_mode(RigidTank const& tank, int number) {
  check_tank(tank);
  if (number < 1) throw std::invalid_argument("sloshing mode: modes count from 1");
  double const d = tank.depth, k = number * pi / tank.length;
  SloshingMode mode;
  mode.number = number;
  mode.wave_number = k;
  mode.angular_frequency = std::sqrt(tank.gravity * k * std::tanh(k * d));
  if (number % 2 == 1)
    mode.mass = tank.mass() * 8.0 * std::tanh(k * d) / (std::pow(number * pi, 3) * d / tank.length);
  mode.height = {d - std::tanh(0.5 * k * d) / k, d - floor_share(k * d, 2.0) / k};
  mode.spring_height = d - 2.0 * std::tanh(0.5 * k * d) / k;
  return mode;
}

ImpulsiveMass impulsive_mass(RigidTank const& tank) {
  check_tank(tank);
  double const d = tank.depth, m = tank.mass();
  double mass = m;
  ForceHeight moment{0.5 * m * d, m * (0.5 * d + tank.length * tank.length / (12.0 * d))};
  for (int n = 1;; n += 2) {
    SloshingMode const mode = sloshing_mode(tank, n);
    mass -= mode.mass;
    moment.walls -= mode.mass * mode.height.walls;
    moment.walls_and_floor -= mode.mass * mode.height.walls_and_floor;
    if (mode.wave_number * d < 20.0 || n < 1001) continue;
    // Masses fall as n^-3 from here on, and heights are d: the rest is half the integral from n
    // + 1.
    double const rest = 0.25 * mode.mass * std::pow(n, 3) / ((n + 1.0) * (n + 1.0));
    mass -= rest;
    moment.walls -= rest * d;
    moment.walls_and_floor -= rest * d;
    break;
  }
  return {mass, {moment.walls / mass, moment.walls_and_floor / mass}};
}

HousnerTank housner_tank(RigidTank const& tank) {
  check_tank(tank);
  double const d = tank.depth, ratio = tank.length / d, m = tank.mass();
  double const x = 0.5 * std::numbers::sqrt3 * ratio, y = 3.16 / ratio;
  HousnerTank housner;
  housner.impulsive.mass = m * std::tanh(x) / x;
  housner.impulsive.height = {d * (ratio < 4.0 / 3.0 ? 0.5 - 0.09375 * ratio : 0.375),
                              d * (ratio < 0.75 ? 0.45 : 0.5 * x / std::tanh(x) - 0.125)};
  housner.convective_mass = m * 0.264 * ratio * std::tanh(y);
  housner.convective_height = {d * (1.0 - std::tanh(0.5 * y) / y),
                               d * (1.0 - floor_share(y, 2.01) / y)};
  housner.convective_angular_frequency =
      std::sqrt(3.16 * tank.gravity / tank.length * std::tanh(y));
  return housner;
}

}  // namespace moraine
