// What a record holds, and where.
//
// A record is the gathered copy of one particle: its position and the fields that the terms of a
// sweep need, side by side, padded to quads of four numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/symmetric.hpp"

namespace moraine {

enum class PairField : std::uint8_t {
  velocity,           // m/s
  pressure_term,      // p / rho^2 [Pa m^6/kg^2]
  compression,        // rho / rho_0 - 1 [-]: small differences survive single precision
  reference_density,  // rho_0 [kg/m^3]
  mass,               // kg
  sound_speed,        // m/s
  normal,             // wall normal into the fluid, or zero [-]
  wall_depth,         // distance behind the wall's face [m], negative where the wall has no slip
  wall_turn,          // normal x angular velocity of the wall [1/s]
  lattice_volume,     // volume of a wall particle, spacing^d [m^d]
  smoothing_length,   // h [m], where particles have their own
  dynamic_viscosity,  // Pa s
  group,              // of materials that the penalty does not keep apart
  density_gradient,   // kg/m^4
  correction,         // correction of the kernel gradient, less the unit matrix [-]
  wall_velocity,      // m/s, where `velocity` is what a wall shows to the terms instead
  volume,             // m / rho [m^d]
  stress_term,        // deviatoric stress / rho^2 [Pa m^6/kg^2]
  artificial_stress,  // what keeps a solid in tension from clumping, / rho^2 [Pa m^6/kg^2]
};
inline constexpr std::size_t pair_field_count = 19;

enum class PairRank : std::uint8_t { scalar, vector, symmetric };

constexpr PairRank rank(PairField field) {
  switch (field) {
    case PairField::velocity:
    case PairField::normal:
    case PairField::wall_turn:
    case PairField::density_gradient:
    case PairField::wall_velocity:
      return PairRank::vector;
    case PairField::correction:
    case PairField::stress_term:
    case PairField::artificial_stress:
      return PairRank::symmetric;
    default:
      return PairRank::scalar;
  }
}

/// Numbers that a field takes in D dimensions.
template <int D>
constexpr int components(PairField field) {
  if (rank(field) == PairRank::symmetric) return symmetric_size<D>;
  return rank(field) == PairRank::vector ? D : 1;
}

/// Where each field lies in a record: position first, then the listed fields.
template <int D, PairField... fields>
struct RecordLayout {
  static constexpr int dimension = D;
  static constexpr int absent = -1;

  static constexpr int offset(PairField wanted) {
    int at = D;
    int found = absent;
    ((found = fields == wanted ? at : found, at += components<D>(fields)), ...);
    return found;
  }
  static constexpr bool has(PairField field) { return offset(field) != absent; }

  static constexpr int width = (D + ... + components<D>(fields));
  static constexpr int quads = (width + 3) / 4;
  static constexpr std::size_t stride = static_cast<std::size_t>(quads) * 4;
};

/// Values of fields that are the same for all particles of a sweep and so are not in its records.
template <class Slot>
using UniformFields = std::array<Slot, pair_field_count>;

}  // namespace moraine
