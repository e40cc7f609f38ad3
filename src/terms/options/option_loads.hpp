// The forces of the optional terms on walls, for the moments at which somebody asks: each pair as
// in the sweep, in double.
#pragma once

#include "terms/mirror_loads.hpp"
#include "terms/options/option_records.hpp"
#include "terms/options/option_sweep.hpp"

namespace moraine {

/// Looks at pairs of the records of a sweep, with terms for numbers of type double that add to a
/// Sum.
template <int D, Flavour flavour, class Scheme, class Sum, class Terms>
class OptionLoads {
  using FluidLayout = typename Scheme::Fluid;
  using WallLayout = typename Scheme::Wall;
  using Vector = std::array<double, 3>;

 public:
  OptionLoads(SweepParameters const& sweep, Terms const& terms,
              OptionRecords<D, flavour, Scheme> const& records)
      : constants_(sweep),
        terms_(terms),
        scale_(sweep.position_scale),
        uniform_(option_uniform<double>(sweep)),
        records_(records) {}

  /// Adds the forces on all wall particles that have fluid near.
  void add_on_walls(ParticleStore const& store, Search const& search,
                    std::vector<WallLoad>& loads) const {
    auto const& wet = search.wet_walls();
    for_each_block(wet.size(), NeighbourList::block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) add(store, search, wet[n], loads[n]);
    });
  }

  /// Adds the forces on mirror walls.
  void add_on_mirrors(ParticleStore const& store, Search const& search,
                      std::vector<MirrorLoad>& loads) const {
    for_each_block(loads.size(), NeighbourList::block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) add(store, search, loads[n]);
    });
  }

 private:
  /// Adds the force on wall particle w.
  void add(ParticleStore const& store, Search const& search, std::size_t w, WallLoad& load) const {
    auto const wall = records_.wall.in_metres(w, scale_);
    Broadcast<double, WallLayout> const neighbour{wall.data(), uniform_.data()};
    auto const& images = search.images(Kind::fluid);
    for (std::uint32_t const j : search.wall_fluid().points(w)) {
      auto const fluid = records_.fluid.in_metres(j, scale_);
      Broadcast<double, FluidLayout> const self{fluid.data(), uniform_.data()};
      std::size_t const owner =
          j < records_.fluid.owned() ? j : images[j - records_.fluid.owned()].source;
      subtract_force<Pairing::fluid_wall>(self, neighbour, store.scalar(Field::mass)[owner],
                                          load.force);
    }
  }

  /// Adds the force of a particle on mirror walls.
  void add(ParticleStore const& store, Search const& search, MirrorLoad& load) const {
    auto const record = records_.fluid.in_metres(load.particle, scale_);
    Broadcast<double, FluidLayout> const self{record.data(), uniform_.data()};
    auto const& images = search.images(Kind::fluid);
    for (std::uint32_t const j : search.fluid_mirrored().points(load.particle)) {
      auto const image = records_.fluid.in_metres(j, scale_);
      Broadcast<double, FluidLayout> const neighbour{image.data(), uniform_.data()};
      auto const side = side_met_first(store, search.settings().sides, load.particle,
                                       images[j - records_.fluid.owned()]);
      subtract_force<Pairing::fluid_fluid>(
          self, neighbour, store.scalar(Field::mass)[load.particle], load.force[side]);
    }
  }

  template <Pairing pairing, class Self, class Neighbour>
  void subtract_force(Self const& self, Neighbour const& neighbour, double mass,
                      Vector& force) const {
    constexpr bool wall = pairing == Pairing::fluid_wall;
    double x[D];
    for (int axis = 0; axis < D; ++axis) x[axis] = self.position(axis) - neighbour.position(axis);
    auto const pair = option_pair<pairing, double, D>(constants_, self, neighbour, x);
    Sum sum{};
    std::apply(
        [&](auto const&... term) { (term.template add<wall>(pair, self, neighbour, sum), ...); },
        terms_);
    for (int axis = 0; axis < D; ++axis)
      force[static_cast<std::size_t>(axis)] -= mass * sum.acceleration[axis];
  }

  OptionConstants<double, D> constants_;
  Terms terms_;
  double scale_;
  UniformFields<double> uniform_;
  OptionRecords<D, flavour, Scheme> const& records_;
};

}  // namespace moraine
