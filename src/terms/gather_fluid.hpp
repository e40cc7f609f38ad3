// Gathering the fluid: state of the particles to records, once per step.
#pragma once

#include "base/parallel_for.hpp"
#include "terms/pair_records.hpp"

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

/// Continues pressure and density of an image at a wall with hydrostatics,
///
///   p' = p + rho g . (x' - x),   rho' = rho + rho_0 g . (x' - x) / c_0^2,
///
/// counted along the axes across the walls; `fall` is x' - x there [m]. Without it the pressure
/// would have a kink at a floor, where its gradient must bear the weight of the water. As in
/// wall_extrapolation.hpp; c_0 as in density_diffusion.hpp, for which such water is at rest.
template <class Pairs>
void continue_into_image(Pairs& pairs, std::size_t i, std::array<double, 3> const& fall) {
  auto& fluid = pairs.fluid;
  auto const& p = pairs.parameters;
  double head = 0.0;    // g . (x' - x) [m^2/s^2]
  double denser = 0.0;  // (rho' - rho) / rho_0
  for (std::size_t axis = 0; axis < 3; ++axis) {
    head += p.gravity[axis] * fall[axis];
    denser += p.hydrostatic_slope[axis] * fall[axis];
  }
  if (head == 0.0) return;
  double rho_0 = p.uniform[static_cast<std::size_t>(PairField::reference_density)];
  if constexpr (!Pairs::Scheme::uniform) rho_0 = fluid.get(i, PairField::reference_density);
  double const compression = fluid.get(i, PairField::compression);
  double const rho = rho_0 * (1.0 + compression);
  double const rho_image = rho + rho_0 * denser;
  double const pressure = fluid.get(i, PairField::pressure_term) * rho * rho + rho * head;
  fluid.set(i, PairField::pressure_term, pressure / (rho_image * rho_image));
  fluid.set(i, PairField::compression, compression + denser);
}

/// What images at walls differ in from those at symmetry planes: gravity, and velocities. The image
/// of a particle at a no-slip wall has all of the velocity reversed; of several reflections each
/// does its part.
template <class Pairs>
void adjust_wall_images(Pairs& pairs, std::vector<Image> const& images, DomainSides const& sides) {
  constexpr auto axes = static_cast<std::size_t>(Pairs::dimension);
  auto& fluid = pairs.fluid;
  for_each_block(images.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (!sides.at_wall(images[k])) continue;
      std::size_t const i = fluid.owned() + k;
      std::array<double, 3> fall{};
      for (std::size_t axis = 0; axis < axes; ++axis) {
        Plane const plane = sides.plane_of(images[k].shift[axis], axis);
        if (plane <= Plane::symmetry) continue;
        fall[axis] =
            pairs.metres_between(fluid.record(i)[axis], fluid.record(images[k].source)[axis]);
        if (plane != Plane::stick_wall) continue;
        for (std::size_t along = 0; along < axes; ++along)
          if (along != axis) fluid.reverse_velocity(i, along);
      }
      continue_into_image(pairs, i, fall);
    }
  });
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
  DomainSides const& sides = search.settings().sides;
  pairs.fluid.refresh(images, sides);
  if (sides.any_wall()) adjust_wall_images(pairs, images, sides);
}

}  // namespace moraine
