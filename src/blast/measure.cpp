#include "blast/measure.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace moraine::blast {
namespace {

using enum Measure;

constexpr std::array measures{
    MeasureInfo{peak_overpressure, "peak_overpressure", Kind::pressure, "kPa", "psi"},
    MeasureInfo{peak_pressure, "peak_pressure", Kind::pressure, "MPa", "psi"},
    MeasureInfo{reflected_overpressure, "reflected_overpressure", Kind::pressure, "kPa", "psi"},
    MeasureInfo{stem_overpressure, "stem_overpressure", Kind::pressure, "kPa", "psi"},
    MeasureInfo{dynamic_pressure, "dynamic_pressure", Kind::pressure, "kPa", "psi"},
    MeasureInfo{impulse, "impulse", Kind::impulse, "kPa ms", "psi ms"},
    MeasureInfo{reflected_impulse, "reflected_impulse", Kind::impulse, "kPa ms", "psi ms"},
    MeasureInfo{arrival_time, "arrival_time", Kind::time, "ms", "ms"},
    MeasureInfo{positive_duration, "positive_duration", Kind::time, "ms", "ms"},
    MeasureInfo{negative_duration, "negative_duration", Kind::time, "ms", "ms"},
    MeasureInfo{front_speed, "front_speed", Kind::speed, "m/s", "ft/s"},
    MeasureInfo{particle_speed, "particle_speed", Kind::speed, "m/s", "ft/s"},
    MeasureInfo{extreme_angle, "extreme_angle", Kind::angle, "deg", "deg"},
    MeasureInfo{path_angle, "path_angle", Kind::angle, "deg", "deg"},
    MeasureInfo{overpressure, "overpressure", Kind::pressure, "kPa", "psi"},
    MeasureInfo{suction, "suction", Kind::pressure, "kPa", "psi"},
    MeasureInfo{sachs_length_of_plane, "sachs_length_of_plane", Kind::length, "m", "ft"},
    MeasureInfo{sachs_length_of_line, "sachs_length_of_line", Kind::length, "m", "ft"},
    MeasureInfo{sachs_length_of_point, "sachs_length_of_point", Kind::length, "m", "ft"},
    MeasureInfo{contact_impulse, "contact_impulse", Kind::momentum, "N s", "lbf s"},
    MeasureInfo{target_impulse, "target_impulse", Kind::impulse, "kPa s", "psi s"},
    MeasureInfo{horizontal_displacement, "horizontal_displacement", Kind::length, "mm", "in"},
    MeasureInfo{vertical_displacement, "vertical_displacement", Kind::length, "mm", "in"},
    MeasureInfo{transient_horizontal_displacement, "transient_horizontal_displacement",
                Kind::length, "mm", "in"},
    MeasureInfo{transient_vertical_displacement, "transient_vertical_displacement", Kind::length,
                "mm", "in"},
    MeasureInfo{crater_diameter, "crater_diameter", Kind::length, "m", "ft"},
    MeasureInfo{rupture_radius, "rupture_radius", Kind::length, "m", "ft"},
    MeasureInfo{camouflet_volume, "camouflet_volume", Kind::volume, "m^3", "ft^3"},
    MeasureInfo{time_constant, "time_constant", Kind::time, "us", "us"},
    MeasureInfo{energy_per_area, "energy_per_area", Kind::energy_per_area, "kJ/m^2", "ft lbf/in^2"},
    MeasureInfo{energy_lost, "energy_lost", Kind::number, "1", "1"},
    MeasureInfo{bubble_radius, "bubble_radius", Kind::length, "m", "ft"},
    MeasureInfo{bubble_period, "bubble_period", Kind::time, "ms", "ms"},
    MeasureInfo{bubble_energy, "bubble_energy", Kind::energy, "MJ", "MJ"},
};

static_assert(
    [] {
      for (std::size_t i = 0; i < measures.size(); ++i)
        if (static_cast<std::size_t>(measures[i].measure) != i) return false;
      return measures.back().measure == bubble_energy;
    }(),
    "measures must be listed in the order of the enum");

constexpr std::array<Dimension, kind_count> dimensions{{
    {"a pressure", "Pa", {"Pa", "kPa", "MPa", "bar", "psi", "atm"}},
    {"an impulse per area", "Pa s", {"Pa s", "kPa ms", "psi ms", "bar ms"}},
    {"a time", "s", {"s", "ms", "us"}},
    {"a length", "m", {"m", "cm", "mm", "ft", "in"}},
    {"a velocity", "m/s", {"m/s", "km/s", "ft/s"}},
    {"an angle", "rad", {"rad", "deg"}},
    {"a volume", "m^3", {"m^3", "ft^3"}},
    {"an impulse", "N s", {"N s", "lbf s"}},
    {"an energy", "J", {"J", "kJ", "MJ"}},
    {"an energy per area", "J/m^2", {"J/m^2", "kJ/m^2"}},
    {"a plain number", "1", {"1"}},
}};

}  // namespace

MeasureInfo const& info(Measure measure) { return measures[static_cast<std::size_t>(measure)]; }

Dimension const& dimension(Kind kind) { return dimensions[static_cast<std::size_t>(kind)]; }

std::string_view unit_of(Measure measure, UnitSystem system) {
  MeasureInfo const& entry = info(measure);
  if (system == UnitSystem::si) return dimension(entry.kind).unit;
  return system == UnitSystem::metric ? entry.metric : entry.imperial;
}

double unit_factor(Kind kind, std::string_view unit) {
  if (unit == "1") return 1.0;
  Conversion const one = to_si("1 " + std::string(unit), dimension(kind));
  if (!one.value) throw std::invalid_argument("\"" + std::string(unit) + "\" " + one.rule);
  return *one.value;
}

}  // namespace moraine::blast
