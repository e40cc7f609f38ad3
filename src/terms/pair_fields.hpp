// What a pair term may read of a particle, and how records and lanes hold it.
//
// A record is the gathered copy of one particle: its position and the fields that the terms of a
// sweep need, side by side, padded to quads of four numbers. Lanes are the same fields of W
// particles at once. Terms see both through the accessors at the end of this file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/macros.hpp"
#include "base/simd.hpp"
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
  group,              // number of the material; those of one group do not repel each other
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

/// W particles at once, read from their records: packed fields in lanes, uniform fields broadcast.
template <class Real, class Layout>
struct Lanes {
  using Number = Real;
  static constexpr bool has(PairField field) { return Layout::has(field); }
  Real packed[Layout::stride];
  SlotOf<Real> const* uniform;

  template <PairField field>
  MORAINE_FORMULA Real get(int component = 0) const {
    if constexpr (Layout::has(field))
      return packed[Layout::offset(field) + component];
    else
      return Real(uniform[static_cast<std::size_t>(field)]);
  }
};

/// One particle whose fields are the same in all lanes; reads its record where it lies.
template <class Real, class Layout>
struct Broadcast {
  using Number = Real;
  static constexpr bool has(PairField field) { return Layout::has(field); }
  SlotOf<Real> const* record;
  SlotOf<Real> const* uniform;

  MORAINE_FORMULA SlotOf<Real> position(int axis) const { return record[axis]; }

  template <PairField field>
  MORAINE_FORMULA Real get(int component = 0) const {
    if constexpr (Layout::has(field))
      return Real(record[Layout::offset(field) + component]);
    else
      return Real(uniform[static_cast<std::size_t>(field)]);
  }
};

template <class P>
MORAINE_FORMULA auto velocity(P const& particle, int axis) {
  return particle.template get<PairField::velocity>(axis);
}
template <class P>
MORAINE_FORMULA auto pressure_term(P const& particle) {
  return particle.template get<PairField::pressure_term>();
}
template <class P>
MORAINE_FORMULA auto compression(P const& particle) {
  return particle.template get<PairField::compression>();
}
template <class P>
MORAINE_FORMULA auto reference_density(P const& particle) {
  return particle.template get<PairField::reference_density>();
}
template <class P>
MORAINE_FORMULA auto mass(P const& particle) {
  return particle.template get<PairField::mass>();
}
template <class P>
MORAINE_FORMULA auto sound_speed(P const& particle) {
  return particle.template get<PairField::sound_speed>();
}
template <class P>
MORAINE_FORMULA auto normal(P const& particle, int axis) {
  return particle.template get<PairField::normal>(axis);
}

template <class P>
MORAINE_FORMULA auto wall_turn(P const& particle, int axis) {
  return particle.template get<PairField::wall_turn>(axis);
}
template <class P>
MORAINE_FORMULA auto lattice_volume(P const& particle) {
  return particle.template get<PairField::lattice_volume>();
}
template <class P>
MORAINE_FORMULA auto smoothing_length(P const& particle) {
  return particle.template get<PairField::smoothing_length>();
}
template <class P>
MORAINE_FORMULA auto dynamic_viscosity(P const& particle) {
  return particle.template get<PairField::dynamic_viscosity>();
}
template <class P>
MORAINE_FORMULA auto group(P const& particle) {
  return particle.template get<PairField::group>();
}
template <class P>
MORAINE_FORMULA auto density_gradient(P const& particle, int axis) {
  return particle.template get<PairField::density_gradient>(axis);
}
template <class P>
MORAINE_FORMULA auto correction(P const& particle, int component) {
  return particle.template get<PairField::correction>(component);
}
template <class P>
MORAINE_FORMULA auto wall_velocity(P const& particle, int axis) {
  return particle.template get<PairField::wall_velocity>(axis);
}
template <class P>
MORAINE_FORMULA auto volume(P const& particle) {
  return particle.template get<PairField::volume>();
}
template <class P>
MORAINE_FORMULA auto stress_term(P const& particle, int component) {
  return particle.template get<PairField::stress_term>(component);
}
template <class P>
MORAINE_FORMULA auto artificial_stress(P const& particle, int component) {
  return particle.template get<PairField::artificial_stress>(component);
}
template <class P>
MORAINE_FORMULA auto wall_depth(P const& particle) {
  return particle.template get<PairField::wall_depth>();
}

/// Density rho = rho_0 (1 + compression) [kg/m^3].
template <class P>
MORAINE_FORMULA auto density(P const& particle) {
  return reference_density(particle) * (number<typename P::Number>(1) + compression(particle));
}

/// Mass that a neighbour counts with [kg]. That of a wall particle is its density times the volume
/// of a lattice cell.
template <bool wall, class P>
MORAINE_FORMULA auto pair_weight(P const& neighbour) {
  if constexpr (wall)
    return density(neighbour) * lattice_volume(neighbour);
  else
    return mass(neighbour);
}

}  // namespace moraine
