// Gathering walls: the fluid's state continued into wall particles, and their records.
#pragma once

#include "base/parallel_for.hpp"
#include "store/place.hpp"
#include "terms/pair_records.hpp"
#include "terms/wall_extrapolation.hpp"

namespace moraine {

/// Place, velocity, normal and depth of wall particle i of the records.
template <class Pairs>
void place_wall(Pairs& pairs, ParticleStore const& store, FixedPoint const& map,
                WallData const& walls, std::size_t i) {
  std::size_t const k = store.range(Kind::wall).begin + i;
  WallPoint const& point = walls.points[store.id()[k] - walls.first_id];
  Vec3 const place = place_of(store, k);
  Vec3 const velocity = walls.velocity(point, place);
  Vec3 const normal = walls.normal(point);
  [[maybe_unused]] Vec3 const turn = cross(normal, walls.angular_velocity(point));
  pairs.wall.set(i, PairField::wall_depth, point.free_slip ? point.depth : -point.depth);
  for (int axis = 0; axis < Pairs::dimension; ++axis) {
    auto const component = static_cast<std::size_t>(axis);
    pairs.wall.set_position(i, axis, place[component], map);
    pairs.wall.set(i, PairField::velocity, velocity[component], axis);
    pairs.wall.set(i, PairField::normal, normal[component], axis);
    if constexpr (Pairs::WallLayout::has(PairField::wall_turn))
      pairs.wall.set(i, PairField::wall_turn, turn[component], axis);
  }
}

/// What stays the same between rebuilds of the lists where walls are at rest.
template <class Pairs>
void place_walls(Pairs& pairs, ParticleStore const& store, Search const& search,
                 WallData const& walls) {
  pairs.wall.resize(store.range(Kind::wall).size(), search.images(Kind::wall).size());
  for_each_block(pairs.wall.owned(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      place_wall(pairs, store, search.settings().fixed_point, walls, i);
  });
}

template <class Pairs>
void continue_into_wall(Pairs const& pairs, ParticleStore& store, Search const& search,
                        WallData const& walls, std::size_t i) {
  std::size_t const k = store.range(Kind::wall).begin + i;
  std::array<double, 3> gravity = pairs.parameters.gravity;
  if (walls.move()) {
    WallPoint const& point = walls.points[store.id()[k] - walls.first_id];
    gravity = subtract(gravity, walls.acceleration(point, place_of(store, k)));
  }
  WallState const state = extrapolate<Pairs::reference, typename Pairs::Real, Pairs::dimension,
                                      typename Pairs::Kernel, typename Pairs::FluidLayout>(
      pairs.parameters, pairs.wall.record(i), pairs.uniform.data(), search.wall_fluid(), i,
      pairs.fluid.data(), gravity);
  if (state.weight <= 0.0) return;
  store.scalar(Field::pressure)[k] = state.pressure;
  store.scalar(Field::density)[k] = state.density;
  store.scalar(Field::sound_speed)[k] = state.sound_speed;
}

template <class Pairs>
void set_wall_state(Pairs& pairs, ParticleStore const& store, std::size_t i) {
  std::size_t const k = store.range(Kind::wall).begin + i;
  double const rho = store.scalar(Field::density)[k];
  double const p = store.scalar(Field::pressure)[k];
  pairs.wall.set(i, PairField::pressure_term, p / (rho * rho));
  if constexpr (Pairs::Scheme::uniform) {
    double const rho_0 =
        pairs.parameters.uniform[static_cast<std::size_t>(PairField::reference_density)];
    pairs.wall.set(i, PairField::compression, (rho - rho_0) / rho_0);
  } else {
    pairs.wall.set(i, PairField::reference_density, rho);
    pairs.wall.set(i, PairField::sound_speed, store.scalar(Field::sound_speed)[k]);
  }
}

/// State and records of the wall particles that have fluid near, then the images.
template <class Pairs>
void gather_wet_walls(Pairs& pairs, ParticleStore& store, Search const& search,
                      WallData const& walls) {
  auto const& wet = search.wet_walls();
  for_each_block(wet.size(), NeighbourList::block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      std::size_t const i = wet[n];
      if (walls.move()) place_wall(pairs, store, search.settings().fixed_point, walls, i);
      continue_into_wall(pairs, store, search, walls, i);
      set_wall_state(pairs, store, i);
    }
  });
  pairs.wall.refresh(search.images(Kind::wall), search.settings().sides);
}

}  // namespace moraine
