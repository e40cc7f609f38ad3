// The neighbour lists of a search, made anew at each rebuild.
#include <algorithm>

#include "search/search.hpp"

namespace moraine {

/// Lists and their validity from points in cell order.
void Search::make_lists(ParticleStore const& store) {
  DomainSides const& sides = settings_.sides;
  bool const images = sides.any();
  for (Kind const kind : {Kind::wall, Kind::fluid})
    if (images && store.range(kind).size() > 0) mix_images(store, kind);
  displacement_.reset(points(Kind::fluid).in_cells(), points(Kind::wall).in_cells(),
                      {reach(), sides.repeats(), sides.plane_units()}, moving_points());
  if (settings_.dimension == 1) collect_neighbours<1>();
  if (settings_.dimension == 2) collect_neighbours<2>();
  if (settings_.dimension == 3) collect_neighbours<3>();
}

template <int D>
void Search::collect_neighbours() {
  Points const& fluid = points(Kind::fluid);
  Points const& wall = points(Kind::wall);
  double const scale = settings_.fixed_point.scale;
  double const case_support = settings_.support / scale;
  double const support = varies() ? largest_support_ : case_support;
  double const fluid_radius = support + skins_.fluid / scale;
  double const wall_radius = std::max(support, case_support) + skins_.wall / scale;
  PairRadius const of_fluid =
      !varies() ? PairRadius::same
                : (settings_.larger_of_two ? PairRadius::larger : PairRadius::mean);
  PairRadius const of_self = varies() ? PairRadius::of_self : PairRadius::same;
  PairRadius const of_other = varies() ? PairRadius::of_other : PairRadius::same;
  // What the radii of single pairs lack beside those of the finder.
  auto const own = [&](std::size_t i) { return varies() ? fluid.support[i] : 0.0F; };
  auto const skin = [&](double metres) { return static_cast<float>(metres / scale); };
  float const least = skin(settings_.support);  // of fluid against walls
  constexpr std::uint32_t nobody = 0xFFFFFFFFu;
  constexpr std::size_t lanes = NeighbourList::lanes(D);
  bool const unsorted = settings_.sides.any();  // images stand among the owned points
  auto const at = [](Points const& p, std::size_t i) {
    UnitPoint x{};
    for (std::size_t axis = 0; axis < D; ++axis) x[axis] = p.x[axis][i];
    return x;
  };
  std::size_t const fluids = fluid.owned;
  std::size_t const walls = wall.owned;

  NeighbourFinder<D> const near_fluid(fluid.in_cells(), fluid_radius, of_fluid, skin(skins_.fluid));
  bool const mirrored = settings_.sides.any_wall();
  auto const is_mirrored = [&](std::uint32_t j) {
    return j >= fluid.owned && fluid.at_wall[j - fluid.owned] != 0;
  };
  fluid_fluid_.build(
      fluids, lanes, unsorted, [&](std::size_t i, CandidateCache& cache, IndexBuffer& buffer) {
        near_fluid(at(fluid, i), static_cast<std::uint32_t>(i), cache, buffer, own(i));
        if (mirrored) buffer.keep_if([&](std::uint32_t j) { return !is_mirrored(j); });
      });
  if (mirrored)
    fluid_mirrored_.build(
        fluids, lanes, unsorted, [&](std::size_t i, CandidateCache& cache, IndexBuffer& buffer) {
          if (!settings_.sides.near_wall(at(fluid, i), fluid_radius)) return;
          near_fluid(at(fluid, i), static_cast<std::uint32_t>(i), cache, buffer, own(i));
          buffer.keep_if(is_mirrored);
        });
  NeighbourFinder<D> const near_wall(wall.in_cells(), wall_radius, of_self, skin(skins_.wall),
                                     least);
  fluid_wall_.build(fluids, lanes, unsorted,
                    [&](std::size_t i, CandidateCache& cache, IndexBuffer& buffer) {
                      UnitPoint const x = at(fluid, i);
                      if (walls > 0 && displacement_.near_wall(x))
                        near_wall(x, nobody, cache, buffer, own(i));
                    });
  NeighbourFinder<D> const wall_near_fluid(fluid.in_cells(), wall_radius, of_other,
                                           skin(skins_.wall), least);
  wall_fluid_.build(walls, lanes, unsorted,
                    [&](std::size_t i, CandidateCache& cache, IndexBuffer& buffer) {
                      UnitPoint const x = at(wall, i);
                      if (displacement_.near_fluid(x)) wall_near_fluid(x, nobody, cache, buffer);
                    });
  wet_walls_.clear();
  for (std::size_t i = 0; i < walls; ++i)
    if (!wall_fluid_.of(i).empty()) wet_walls_.push_back(static_cast<std::uint32_t>(i));
}

}  // namespace moraine
