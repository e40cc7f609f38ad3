#include "blast/displacement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

constexpr std::array<DisplacedGround, 3> grounds{{
    {"clay", 200.0, 145.0},
    {"chalk", 25.0, 19.0},
    {"sand", 126.0, 36.0},
}};

/// W^(1/3) in lb^(1/3) and lb^(1/3)/ft times 1/R.
struct Scaled {
  double size;
  double inverse_distance;
};

Scaled scaled(double charge_mass, double distance) {
  double const size = std::cbrt(charge_mass / pound);
  return {size, size * foot / distance};
}

double transient(Scaled const& s, double cubic, double linear) {
  double const x = s.inverse_distance;
  return inch * s.size * (cubic * x * x + linear) * x;
}

}  // namespace

std::span<DisplacedGround const> displaced_grounds() { return grounds; }

DisplacedGround const* find_displaced_ground(std::string_view name) {
  auto const found = std::ranges::find(grounds, name, &DisplacedGround::name);
  return found == grounds.end() ? nullptr : &*found;
}

double permanent_displacement(double charge_mass, double distance, double c) {
  Scaled const s = scaled(charge_mass, distance);
  double const square = s.inverse_distance * s.inverse_distance;
  return inch * s.size * c * square * square;
}

double transient_horizontal_displacement(double charge_mass, double distance) {
  return transient(scaled(charge_mass, distance), 47.3, 0.216);
}

double transient_vertical_displacement(double charge_mass, double distance) {
  return transient(scaled(charge_mass, distance), 12.6, 0.032);
}

}  // namespace moraine::blast
