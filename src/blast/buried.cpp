#include "blast/buried.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

constexpr std::array<Soil, 9> soil_list{{
    {"dry_soil", 750.0, false, ""},
    {"moist_soil", 1500.0, false, ""},
    {"loam", 2000.0, false, "loam and silt"},
    {"silty_clay", 5000.0, false, ""},
    {"gravelly_clay", 7500.0, false, ""},
    {"sandy_clay", 1500.0, true, "k is printed as 1500 psi; 15 000 is likely"},
    {"dense_sand", 50000.0, false, ""},
    {"saturated_clay", 100000.0, false, ""},
    {"limestone", 590000.0, false, ""},
}};

double cube_root_of_mass(BuriedCharge const& charge) { return std::cbrt(charge.mass / pound); }

/// R/W^(1/3) in ft/lb^(1/3).
double scaled(BuriedCharge const& charge) {
  return charge.distance / foot / cube_root_of_mass(charge);
}

/// k^(-1/2) R^(1/2) W^(1/6), imperial.
double duration_scale(BuriedCharge const& charge) {
  return std::sqrt(charge.distance / foot * cube_root_of_mass(charge) / charge.soil_k);
}

}  // namespace

std::span<Soil const> soils() { return soil_list; }

Soil const* find_soil(std::string_view name) {
  auto const found = std::ranges::find(soil_list, name, &Soil::name);
  return found == soil_list.end() ? nullptr : &*found;
}

double buried_pressure(BuriedCharge const& charge) {
  double const z = scaled(charge);
  return psi * charge.explosive_factor * charge.coupling * charge.soil_k / (z * z * z);
}

double buried_impulse(BuriedCharge const& charge) {
  return psi * 0.076 * charge.explosive_factor * std::sqrt(charge.soil_k) * charge.coupling *
         cube_root_of_mass(charge) * std::pow(scaled(charge), -2.5);
}

double buried_positive_duration(BuriedCharge const& charge) {
  return 0.174 * duration_scale(charge);
}

double buried_negative_duration(BuriedCharge const& charge) {
  return 0.368 * duration_scale(charge);
}

}  // namespace moraine::blast
