// Records of the optional terms, and how they are filled.
#pragma once

#include <vector>

#include "terms/gather_fluid.hpp"
#include "terms/options/option_backend.hpp"
#include "terms/options/option_schemes.hpp"
#include "terms/records.hpp"

namespace moraine {

template <int D, Flavour flavour, class Scheme>
class OptionRecords {
 public:
  static constexpr int dimension = D;
  using Slot = typename LaneType<D, flavour>::Slot;
  using Fluid = Records<Slot, typename Scheme::Fluid>;
  using Wall = Records<Slot, typename Scheme::Wall>;

  OptionRecords(SweepParameters const& sweep, OptionMatter matter)
      : fluid(sweep.smoothing_length),
        wall(sweep.smoothing_length),
        sweep_(sweep),
        matter_(std::move(matter)) {}

  void gather_fluid(ParticleStore const& store, Search const& search, double ahead) {
    std::size_t const count = store.range(Kind::fluid).size();
    fluid.resize(count, search.images(Kind::fluid).size());
    for_each_block(count, loop_block, [&](std::size_t begin, std::size_t end) {
      gather_vectors(*this, store, search.settings().fixed_point, ahead, {begin, end});
      gather_scalars(store, ahead, {begin, end});
    });
    refresh_images(fluid, search, sweep_);
  }

  /// Wall particles that have fluid near; each shows the velocity of its wall.
  void gather_walls(ParticleStore const& store, Search const& search, WallData const& walls) {
    auto const& images = search.images(Kind::wall);
    wall.resize(store.range(Kind::wall).size(), images.size());
    auto const& wet = search.wet_walls();
    for_each_block(wet.size(), loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        gather_wall(store, search.settings().fixed_point, walls, wet[n]);
    });
    wall.refresh(images, search.settings().sides);
  }

  Fluid fluid;
  Wall wall;

 private:
  /// Sets a field where the records have it.
  template <PairField field>
  void put(std::size_t i, double value, int component = 0) {
    if constexpr (Scheme::Fluid::has(field)) fluid.set(i, field, value, component);
  }

  void gather_scalars(ParticleStore const& store, double ahead, Range block) {
    auto const density = store.scalar(Field::density);
    auto const rate = store.scalar(Field::density_rate);
    auto const mass = store.scalar(Field::mass);
    auto const sound_speed = store.scalar(Field::sound_speed);
    auto const pressure = store.scalar(Field::pressure);
    bool const varies = store.has(Field::smoothing_length);
    double const to_now = sweep_.summed_density ? 0.0 : ahead;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      MaterialId const material = store.material()[i];
      double const rho = density[i] + to_now * rate[i];
      double const rho_0 = matter_.reference_density[material];
      put<PairField::compression>(i, (rho - rho_0) / rho_0);
      put<PairField::reference_density>(i, rho_0);
      put<PairField::mass>(i, mass[i]);
      put<PairField::volume>(i, mass[i] / rho);
      put<PairField::sound_speed>(i, sound_speed[i]);
      put<PairField::smoothing_length>(
          i, varies ? store.scalar(Field::smoothing_length)[i] : sweep_.smoothing_length);
      if constexpr (Scheme::Fluid::has(PairField::dynamic_viscosity))
        put<PairField::dynamic_viscosity>(i, matter_.dynamic_viscosity[material]);
      if constexpr (Scheme::Fluid::has(PairField::group))
        put<PairField::group>(i, matter_.penalty_group[material]);
      put<PairField::pressure_term>(i, pressure[i] / (rho * rho));
      if constexpr (Scheme::Fluid::has(PairField::stress_term))
        for (int k = 0; k < symmetric_size<D>; ++k)
          put<PairField::stress_term>(
              i, store.component(Field::predicted_stress, k)[i] / (rho * rho), k);
    }
  }

  void gather_wall(ParticleStore const& store, FixedPoint const& map, WallData const& walls,
                   std::size_t i) {
    std::size_t const k = store.range(Kind::wall).begin + i;
    WallPoint const& point = walls.points[store.id()[k] - walls.first_id];
    Vec3 place{};
    for (int axis = 0; axis < D; ++axis)
      place[static_cast<std::size_t>(axis)] = store.component(Field::position, axis)[k];
    Vec3 const velocity = walls.velocity(point, place);
    Vec3 const normal = walls.normal(point);
    for (int axis = 0; axis < D; ++axis) {
      auto const component = static_cast<std::size_t>(axis);
      wall.set_position(i, axis, place[component], map);
      wall.set(i, PairField::velocity, velocity[component], axis);
      wall.set(i, PairField::wall_velocity, velocity[component], axis);
      wall.set(i, PairField::normal, normal[component], axis);
    }
    double const rho = store.scalar(Field::density)[k];
    wall.set(i, PairField::reference_density, rho);
    wall.set(i, PairField::pressure_term, store.scalar(Field::pressure)[k] / (rho * rho));
    wall.set(i, PairField::wall_depth, point.free_slip ? point.depth : -point.depth);
  }

  SweepParameters sweep_;
  OptionMatter matter_;
};

}  // namespace moraine
