// The one table of particle fields: name, unit, rank, whether a checkpoint saves it,
// whether wall particles have it, whether only some runs do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace moraine {

enum class Field : std::uint8_t {
  position,
  velocity,
  density,
  specific_energy,
  mass,
  pressure,
  sound_speed,
  acceleration,
  density_rate,
  energy_rate,
  burn_fraction,
  lighting_time,
  smoothing_length,
  drift,
  deviatoric_stress,
  predicted_stress,
  velocity_gradient,
  plastic_strain,
  plastic_work,
  rest_density,
  spalled,
  distension,
};

/// A symmetric field keeps the diagonal, then xy, xz, yz (base/symmetric.hpp); a matrix its rows.
enum class Rank : std::uint8_t { scalar, vector, symmetric, matrix };
inline constexpr int most_components = 9;

/// Numbers that a field of this rank has in `dimension` dimensions.
constexpr int components(Rank rank, int dimension) {
  switch (rank) {
    case Rank::scalar:
      return 1;
    case Rank::vector:
      return dimension;
    case Rank::symmetric:
      return dimension * (dimension + 1) / 2;
    case Rank::matrix:
      return dimension * dimension;
  }
  return 0;
}

struct FieldInfo {
  Field field;
  std::string_view name;
  std::string_view unit;
  Rank rank;
  bool saved;     // part of the state that a checkpoint must hold
  bool on_walls;  // wall particles have it too; otherwise its arrays end with the fluid
  bool optional;  // only where ParticleStore::use asks for it
  std::string_view meaning;
};

inline constexpr std::array field_table{
    FieldInfo{Field::position, "position", "m", Rank::vector, true, true, false,
              "place of the particle"},
    FieldInfo{Field::velocity, "velocity", "m/s", Rank::vector, true, false, false,
              "velocity of the particle"},
    FieldInfo{Field::density, "density", "kg/m^3", Rank::scalar, true, true, false, "mass density"},
    FieldInfo{Field::specific_energy, "specific_energy", "J/kg", Rank::scalar, true, false, false,
              "internal energy per mass"},
    FieldInfo{Field::mass, "mass", "kg", Rank::scalar, true, false, false,
              "mass (per metre of thickness in 2D, per square metre in 1D)"},
    FieldInfo{Field::pressure, "pressure", "Pa", Rank::scalar, true, true, false,
              "pressure, positive in compression"},
    FieldInfo{Field::sound_speed, "sound_speed", "m/s", Rank::scalar, true, true, false,
              "adiabatic speed of sound"},
    FieldInfo{Field::acceleration, "acceleration", "m/s^2", Rank::vector, true, false, false,
              "rate of velocity, gravity included"},
    FieldInfo{Field::density_rate, "density_rate", "kg/(m^3 s)", Rank::scalar, true, false, false,
              "rate of density"},
    FieldInfo{Field::energy_rate, "energy_rate", "W/kg", Rank::scalar, true, false, false,
              "rate of specific energy"},
    FieldInfo{Field::burn_fraction, "burn_fraction", "", Rank::scalar, true, false, true,
              "part of the explosive that has burnt, with programmed burn; 0 elsewhere"},
    FieldInfo{Field::lighting_time, "lighting_time", "s", Rank::scalar, true, false, true,
              "when the front of a programmed burn gets to the particle; infinite: never"},
    FieldInfo{Field::smoothing_length, "smoothing_length", "m", Rank::scalar, true, false, true,
              "smoothing length, where it follows the density"},
    FieldInfo{Field::drift, "drift", "m/s", Rank::vector, true, false, true,
              "velocity of the place less that of the material: averaging and shifting"},
    FieldInfo{Field::deviatoric_stress, "deviatoric_stress", "Pa", Rank::symmetric, true, false,
              true, "stress of solids less its mean, tension positive"},
    FieldInfo{Field::predicted_stress, "predicted_stress", "Pa", Rank::symmetric, false, false,
              true, "deviatoric stress predicted to the end of the step, for the pair terms"},
    FieldInfo{Field::velocity_gradient, "velocity_gradient", "1/s", Rank::matrix, true, false, true,
              "gradient of the velocity, d v_a / d x_b, of solids"},
    FieldInfo{Field::plastic_strain, "plastic_strain", "", Rank::scalar, true, false, true,
              "equivalent plastic strain, summed up"},
    FieldInfo{Field::plastic_work, "plastic_work", "J/kg", Rank::scalar, true, false, true,
              "work of the stress on plastic strain, per mass; part of the internal energy"},
    FieldInfo{Field::rest_density, "rest_density", "kg/m^3", Rank::scalar, true, false, true,
              "density that absorbing layers let the particle come back to; 0 outside of them"},
    FieldInfo{Field::spalled, "spalled", "", Rank::scalar, true, false, true,
              "1 where the material has parted in tension and bears none any more, else 0"},
    FieldInfo{Field::distension, "distension", "", Rank::scalar, true, false, true,
              "least density of the solid over that of the whole that compaction has left; 1 "
              "elsewhere"},
};
inline constexpr std::size_t field_count = field_table.size();

constexpr FieldInfo const& info(Field field) {
  return field_table[static_cast<std::size_t>(field)];
}

static_assert(
    [] {
      for (std::size_t i = 0; i < field_count; ++i)
        if (static_cast<std::size_t>(field_table[i].field) != i) return false;
      return true;
    }(),
    "field_table must list the fields in the order of the enum");

}  // namespace moraine
