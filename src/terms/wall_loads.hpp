// The forces of the fluid on single wall particles, for the moments at which somebody asks.
#pragma once

#include "base/parallel_for.hpp"
#include "terms/pair_records.hpp"
#include "terms/reference_sweep.hpp"
#include "terms/schemes.hpp"

namespace moraine {

/// The force of all fluid particles on wall particle w: each pair as in the sweep, in double.
template <class Pairs>
WallLoad load_on_wall(Pairs const& pairs, ParticleStore const& store, Search const& search,
                      std::size_t w) {
  constexpr int D = Pairs::dimension;
  auto const& p = pairs.parameters;
  auto const terms = wall_terms<double>(p);
  auto const uniform = p.template uniform_as<double>();
  auto const wall = pairs.wall.in_metres(w, p.position_scale);
  static constexpr std::array<std::uint32_t, 1> only{0};
  auto const& images = search.images(Kind::fluid);
  WallLoad load;
  for (std::uint32_t const j : search.wall_fluid().points(w)) {
    auto const fluid = pairs.fluid.in_metres(j, p.position_scale);
    double distance2 = 0.0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis)
      distance2 += (fluid[axis] - wall[axis]) * (fluid[axis] - wall[axis]);
    double const reach = kernel_support * pairs.wall_smoothing(j);
    if (distance2 >= reach * reach) continue;
    load.wet = true;
    Broadcast<double, typename Pairs::FluidLayout> const self{fluid.data(), uniform.data()};
    PairSum<double, D> sum{};
    reference_sum<true, D, typename Pairs::Kernel, typename Pairs::WallLayout>(
        p, self, only, wall.data(), terms, sum);
    std::size_t const owner = j < pairs.fluid.owned() ? j : images[j - pairs.fluid.owned()].source;
    double const mass = store.scalar(Field::mass)[owner];
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis)
      load.force[axis] -= mass * sum.acceleration[axis];
  }
  return load;
}

/// As PairBackend::loads_on_walls.
template <class Pairs>
void add_up_wall_loads(Pairs const& pairs, ParticleStore const& store, Search const& search,
                       std::vector<WallLoad>& loads) {
  auto const& wet = search.wet_walls();
  loads.resize(wet.size());
  for_each_block(wet.size(), NeighbourList::block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) loads[n] = load_on_wall(pairs, store, search, wet[n]);
  });
}

}  // namespace moraine
