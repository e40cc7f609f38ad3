// Gathering the fluid: state of the particles to records, once per step.
#pragma once

#include "base/parallel_for.hpp"
#include "terms/pair_records.hpp"
#include "terms/wall_images.hpp"

namespace moraine {

template <class Pairs>
void gather_vectors(Pairs& pairs, ParticleStore const& store, FixedPoint const& map, double ahead,
                    Range const& range) {
  for (int axis = 0; axis < Pairs::dimension; ++axis) {
    auto const x = store.component(Field::position, axis);
    auto const v = store.component(Field::velocity, axis);
    auto const a = store.component(Field::acceleration, axis);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      pairs.fluid.set_position(i, axis, x[i], map);
      pairs.fluid.set(i, PairField::velocity, v[i] + ahead * a[i], axis);
    }
  }
}

template <class Pairs>
void gather_scalars(Pairs& pairs, ParticleStore const& store, double ahead, Range const& range) {
  auto const density = store.scalar(Field::density);
  auto const density_rate = store.scalar(Field::density_rate);
  auto const pressure = store.scalar(Field::pressure);
  auto const material = store.material();
  double const to_now = pairs.parameters.summed_density ? 0.0 : ahead;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    double const rho = density[i] + to_now * density_rate[i];
    double const rho_0 = pairs.reference_densities[material[i]];
    pairs.fluid.set(i, PairField::pressure_term, pressure[i] / (rho * rho));
    pairs.fluid.set(i, PairField::compression, (rho - rho_0) / rho_0);
    if constexpr (!Pairs::Scheme::uniform) {
      pairs.fluid.set(i, PairField::reference_density, rho_0);
      pairs.fluid.set(i, PairField::mass, store.scalar(Field::mass)[i]);
      pairs.fluid.set(i, PairField::sound_speed, store.scalar(Field::sound_speed)[i]);
    }
    if constexpr (Pairs::varies)
      pairs.fluid.set(i, PairField::smoothing_length, store.scalar(Field::smoothing_length)[i]);
  }
}

/// As PairBackend::gather_fluid.
template <class Pairs>
void gather_fluid_records(Pairs& pairs, ParticleStore const& store, Search const& search,
                          double ahead) {
  std::size_t const owned = store.range(Kind::fluid).size();
  auto const& images = search.images(Kind::fluid);
  pairs.fluid.resize(owned, images.size());
  pairs.parameters.position_scale = search.settings().fixed_point.scale;
  for_each_block(owned, loop_block, [&](std::size_t begin, std::size_t end) {
    gather_vectors(pairs, store, search.settings().fixed_point, ahead, {begin, end});
    gather_scalars(pairs, store, ahead, {begin, end});
  });
  refresh_images(pairs.fluid, search, pairs.parameters);
}

}  // namespace moraine
