#include "blast/crater.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

constexpr std::array<BrokenGround, 9> grounds{{
    {"hard_rock", 3.3, 3.3},
    {"soft_rock", 4.3, 4.3},
    {"hard_chalk", 4.7, 4.7},
    {"soft_chalk", 5.4, 5.4},
    {"clay", 6.2, 6.2},
    {"silt", 6.7, 6.7},
    {"gravel", 6.8, 6.8},
    {"sand", 7.5, 7.8},
    {"fill", 7.7, 9.7},
}};

}  // namespace

double crater_diameter(double charge_mass, double c) { return c * std::cbrt(charge_mass); }

double lampson_crater_diameter(double charge_mass, double soil_k, double depth_factor) {
  return foot * 2.6 * depth_factor * std::pow(soil_k, 0.05) * std::cbrt(charge_mass / pound);
}

double camouflet_volume(double charge_mass) {
  return 10.0 * foot * foot * foot * (charge_mass / pound);
}

std::span<BrokenGround const> broken_grounds() { return grounds; }

BrokenGround const* find_broken_ground(std::string_view name) {
  auto const found = std::ranges::find(grounds, name, &BrokenGround::name);
  return found == grounds.end() ? nullptr : &*found;
}

double rupture_radius(double charge_mass, double f) {
  return foot * f * std::cbrt(charge_mass / pound);
}

CraterType crater_type(double charge_mass, double depth, double rupture_factor) {
  if (depth < charge_radius(charge_mass)) return CraterType::scour;
  return depth < rupture_radius(charge_mass, rupture_factor) ? CraterType::throw_out
                                                             : CraterType::camouflet;
}

double charge_radius(double charge_mass) {
  return std::cbrt(3.0 * charge_mass / (4.0 * std::numbers::pi * tnt_density));
}

}  // namespace moraine::blast
