// Sums of the optional terms over all that is around a particle.
#pragma once

#include <cmath>

#include "terms/options/option_records.hpp"
#include "terms/options/option_sums.hpp"
#include "terms/options/option_sweep.hpp"

namespace moraine {

/// The gathered records, and sums of any terms over the lists of a particle.
template <int D, Flavour flavour, class Scheme>
struct OptionNeighbours {
  using Slot = typename LaneType<D, flavour>::Slot;
  using Real = typename LaneType<D, flavour>::Real;
  using FluidLayout = typename Scheme::Fluid;
  using WallLayout = typename Scheme::Wall;
  using Constants = OptionConstants<Real, D>;

  OptionNeighbours(SweepParameters const& parameters, OptionMatter matter)
      : sweep(parameters),
        uniform(option_uniform<Slot>(parameters)),
        records(parameters, std::move(matter)) {}

  void gather(ParticleStore const& store, Search const& search, WallData const& walls,
              double ahead) {
    sweep.position_scale = search.settings().fixed_point.scale;
    records.gather_fluid(store, search, ahead);
    records.gather_walls(store, search, walls);
  }

  template <class Use>
  void for_each_particle(Use&& use) const {
    for_each_block(records.fluid.owned(), NeighbourList::block,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) use(i);
                   });
  }

  Broadcast<Real, FluidLayout> self(std::size_t i) const {
    return {records.fluid.record(i), uniform.data()};
  }

  template <class Terms, class AnySum>
  void add_fluid(Search const& search, std::size_t i, Terms const& terms, AnySum& sum) const {
    sum_options<Pairing::fluid_fluid, FluidLayout, Real, D>(
        Constants(sweep), self(i), search.fluid_fluid().of(i), records.fluid.data(), terms, sum);
  }
  /// Images at mirror walls are fluid too. Where those walls keep the work, as in the main sweep
  /// (terms/pair_backend_impl.hpp), de_i/dt = - v_i . dv_i/dt, and heat takes the difference.
  template <class Terms, class AnySum>
  void add_mirrored(Search const& search, std::size_t i, Terms const& terms, AnySum& sum) const {
    if (!sweep.mirror_walls || search.fluid_mirrored().of(i).empty()) return;
    AnySum const before = sum;
    sum_options<Pairing::fluid_fluid, FluidLayout, Real, D>(
        Constants(sweep), self(i), search.fluid_mirrored().of(i), records.fluid.data(), terms, sum);
    if constexpr (requires { sum.energy_rate; })
      if (sweep.walls_keep_work) keep_work(self(i), before, sum);
  }
  template <class Self, class AnySum>
  static void keep_work(Self const& particle, AnySum const& before, AnySum& sum) {
    Real const shared = sum.energy_rate - before.energy_rate;
    Real work = number<Real>(0);
    for (int axis = 0; axis < D; ++axis)
      work += (sum.acceleration[axis] - before.acceleration[axis]) * velocity(particle, axis);
    sum.energy_rate = before.energy_rate - work;
    if constexpr (requires { sum.viscous_heat; }) {
      Real const other = shared - sum.viscous_heat + before.viscous_heat;
      sum.viscous_heat = before.viscous_heat - work - other;
    }
  }
  template <class Terms, class AnySum>
  void add_walls(Search const& search, std::size_t i, Terms const& terms, AnySum& sum) const {
    add_mirrored(search, i, terms, sum);
    if (search.fluid_wall().of(i).empty()) return;
    sum_options<Pairing::fluid_wall, WallLayout, Real, D>(
        Constants(sweep), self(i), search.fluid_wall().of(i), records.wall.data(), terms, sum);
  }
  template <class Terms, class AnySum>
  void add_all(Search const& search, std::size_t i, Terms const& terms, AnySum& sum) const {
    add_fluid(search, i, terms, sum);
    add_walls(search, i, terms, sum);
  }

  double own_smoothing(std::size_t i) const {
    return records.fluid.get(i, PairField::smoothing_length);
  }
  /// W(0) of a particle [1/m^d].
  double central_kernel(std::size_t i) const {
    AnyKernel<D> const kernel(sweep.kernel);
    return kernel.sigma / std::pow(own_smoothing(i), D) * kernel.shape(0.0);
  }

  /// Walls without slip show the velocity that makes that of the fluid at their face theirs.
  void show_fluid_to_walls(Search const& search) {
    auto const& wet = search.wet_walls();
    for_each_block(wet.size(), NeighbourList::block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        std::size_t const w = wet[n];
        Broadcast<Real, WallLayout> const wall{records.wall.record(w), uniform.data()};
        VelocitySum<Real, D> sum{};
        sum_options<Pairing::wall_fluid, FluidLayout, Real, D>(
            Constants(sweep), wall, search.wall_fluid().of(w), records.fluid.data(),
            std::tuple{VelocityBeforeWall{}}, sum);
        double const weight = sum_of_lanes(sum.weight);
        if (!(weight > 0.0)) continue;
        for (int axis = 0; axis < D; ++axis)
          records.wall.set(w, PairField::velocity,
                           2.0 * records.wall.get(w, PairField::wall_velocity, axis) -
                               sum_of_lanes(sum.velocity[axis]) / weight,
                           axis);
      }
    });
    records.wall.refresh(search.images(Kind::wall), search.settings().sides);
  }

  SweepParameters sweep;
  UniformFields<Slot> uniform;
  OptionRecords<D, flavour, Scheme> records;
};

}  // namespace moraine
