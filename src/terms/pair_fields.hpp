// What a pair term may read of a particle, and how lanes hold it.
//
// Lanes are the fields of the records (record_layout.hpp) of W particles at once. Terms see both
// through the accessors at the end of this file.
#pragma once

#include "base/macros.hpp"
#include "base/simd.hpp"
#include "terms/record_layout.hpp"

namespace moraine {

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
