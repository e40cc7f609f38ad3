// The forces of single fluid particles on mirror walls, for the moments at which somebody asks.
#pragma once

#include "base/parallel_for.hpp"
#include "terms/pair_records.hpp"
#include "terms/reference_sweep.hpp"
#include "terms/schemes.hpp"

namespace moraine {

/// The wall side, 2 axis + end, that the line from particle i to an image meets first.
inline std::size_t side_met_first(ParticleStore const& store, DomainSides const& sides,
                                  std::size_t i, Image const& image) {
  std::size_t first = 0;
  double least = 2.0;
  for (int axis = 0; axis < store.dimension(); ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    if (sides.plane_of(image.shift[k], k) <= Plane::symmetry) continue;
    std::size_t const end = image.shift[k] > 0 ? 1 : 0;
    auto const x = store.component(Field::position, axis);
    auto const gap = [&](std::size_t particle) {
      double const ahead = x[particle] - sides.low[k];
      return end == 0 ? ahead : sides.length[k] - ahead;
    };
    double const way = gap(i) / (gap(i) + gap(image.source));
    if (!(way < least)) continue;
    least = way;
    first = 2 * k + end;
  }
  return first;
}

/// The load of particle i: each pair as in the sweep, in double.
template <class Pairs>
MirrorLoad mirror_load(Pairs const& pairs, ParticleStore const& store, Search const& search,
                       std::size_t i) {
  constexpr int D = Pairs::dimension;
  auto const& p = pairs.parameters;
  auto const terms = fluid_terms<double, D>(p);
  auto const uniform = p.template uniform_as<double>();
  auto const record = pairs.fluid.in_metres(i, p.position_scale);
  Broadcast<double, typename Pairs::FluidLayout> const self{record.data(), uniform.data()};
  static constexpr std::array<std::uint32_t, 1> only{0};
  auto const& images = search.images(Kind::fluid);
  double const mass = store.scalar(Field::mass)[i];
  MirrorLoad load{static_cast<std::uint32_t>(i), {}};
  for (std::uint32_t const j : search.fluid_mirrored().points(i)) {
    auto const image = pairs.fluid.in_metres(j, p.position_scale);
    PairSum<double, D> sum{};
    reference_sum<false, D, typename Pairs::Kernel, typename Pairs::FluidLayout>(
        p, self, only, image.data(), terms, sum);
    auto& force = load.force[side_met_first(store, search.settings().sides, i,
                                            images[j - pairs.fluid.owned()])];
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis)
      force[axis] -= mass * sum.acceleration[axis];
  }
  return load;
}

/// As PairBackend::loads_on_mirrors.
template <class Pairs>
void add_up_mirror_loads(Pairs const& pairs, ParticleStore const& store, Search const& search,
                         std::vector<MirrorLoad>& loads) {
  loads.clear();
  if (!pairs.parameters.mirror_walls) return;
  for (std::size_t i = 0; i < pairs.fluid.owned(); ++i)
    if (!search.fluid_mirrored().of(i).empty())
      loads.push_back({static_cast<std::uint32_t>(i), {}});
  for_each_block(loads.size(), NeighbourList::block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      loads[n] = mirror_load(pairs, store, search, loads[n].particle);
  });
}

}  // namespace moraine
