// The quantities that relations give, and the units in which people read them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/units.hpp"

namespace moraine::blast {

/// Kinds of quantity that share a choice of unit.
enum class Kind : std::uint8_t {
  pressure,
  impulse,  // per area
  time,
  length,
  speed,
  angle,
  volume,
  momentum,
  energy,
  energy_per_area,
  number,
};
inline constexpr std::size_t kind_count = 11;

enum class Measure : std::uint8_t {
  peak_overpressure,
  peak_pressure,
  reflected_overpressure,
  stem_overpressure,
  dynamic_pressure,
  impulse,
  reflected_impulse,
  arrival_time,
  positive_duration,
  negative_duration,
  front_speed,
  particle_speed,
  extreme_angle,
  path_angle,
  overpressure,
  suction,
  sachs_length_of_plane,
  sachs_length_of_line,
  sachs_length_of_point,
  contact_impulse,
  target_impulse,
  horizontal_displacement,
  vertical_displacement,
  transient_horizontal_displacement,
  transient_vertical_displacement,
  crater_diameter,
  rupture_radius,
  camouflet_volume,
  time_constant,
  energy_per_area,
  energy_lost,
  bubble_radius,
  bubble_period,
  bubble_energy,
};

/// Systems of units for results.
enum class UnitSystem : std::uint8_t { si, metric, imperial };

struct MeasureInfo {
  Measure measure;
  std::string_view name;  // "peak_overpressure"
  Kind kind;
  std::string_view metric;
  std::string_view imperial;
};

/// The entry of the table of measures. Never fails.
MeasureInfo const& info(Measure measure);

/// Name with its article, SI unit and usual units of a kind, for reading and converting.
Dimension const& dimension(Kind kind);

/// The unit of a measure in a system, in the notation of UDUNITS-2; "1" for plain numbers.
std::string_view unit_of(Measure measure, UnitSystem system);

/// SI value of one `unit`: value in the unit = value in SI / factor. `unit` must be of the kind.
double unit_factor(Kind kind, std::string_view unit);

}  // namespace moraine::blast
