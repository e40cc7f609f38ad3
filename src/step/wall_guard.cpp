#include "step/wall_guard.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/parallel_for.hpp"
#include "step/bad_particles.hpp"

namespace moraine {
namespace {

/// A fluid particle of a list, and which of its images: those are seen elsewhere.
struct Seen {
  std::size_t particle;
  std::array<std::int8_t, 3> shift;
};

Seen seen(Search const& search, std::uint32_t listed) {
  std::size_t const owned = search.fluid_fluid().size();
  if (listed < owned) return {listed, {}};
  Image const& image = search.images(Kind::fluid)[listed - owned];
  return {image.source, image.shift};
}

/// Square of the distance from a wall particle to a fluid particle as it is seen.
double distance2(WallGuardView const& view, Components const& x, std::size_t wall,
                 Seen const& fluid) {
  double sum = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(view.store.dimension()); ++k) {
    double place = x[k][fluid.particle];
    if (fluid.shift[k] != 0)
      place = view.search.settings().sides.image_place(place, fluid.shift[k], k);
    sum += (place - x[k][wall]) * (place - x[k][wall]);
  }
  return sum;
}

/// Calls visit(particle, depth) for all fluid particles in the ball of wet wall particle number `n`
/// that are deeper than `bound`. Wall particles that are no deeper themselves, the first row, whose
/// lists are the longest, are passed over.
template <class Visit>
void for_each_inside(WallGuardView const& view, Components const& x, double bound, std::size_t n,
                     Visit&& visit) {
  std::uint32_t const index = view.search.wet_walls()[n];
  std::size_t const wall = view.store.range(Kind::wall).begin + index;
  WallPoint const& point = view.walls.points[view.store.id()[wall] - view.walls.first_id];
  double const depth = static_cast<double>(point.depth);
  double const radius = std::min(static_cast<double>(point.clearance), depth - bound);
  if (!(radius > 0.0)) return;
  NeighbourList const& list = view.search.wall_fluid();
  NeighbourGroups const groups = list.of(index);
  for (std::size_t k = 0; k < groups.count * list.lanes(); ++k) {
    std::uint32_t const slot = groups.bases[k / list.lanes()] + groups.offsets[k];
    if (is_nowhere(slot)) continue;
    Seen const fluid = seen(view.search, point_at(slot));
    double const away2 = distance2(view, x, wall, fluid);
    if (away2 < radius * radius) visit(fluid.particle, depth - std::sqrt(away2));
  }
}

}  // namespace

double deepest_in_walls(WallGuardView const& view, double bound) {
  Components const x = components_of(view.store, Field::position);
  auto const in_block = [&](std::size_t begin, std::size_t end) {
    double depth = 0.0;
    for (std::size_t n = begin; n < end; ++n)
      for_each_inside(view, x, bound, n,
                      [&](std::size_t, double found) { depth = std::max(depth, found); });
    return depth;
  };
  return reduce_blocks(view.search.wet_walls().size(), 0.0, in_block,
                       [](double a, double b) { return std::max(a, b); });
}

std::vector<Suspect> deeper_in_walls(WallGuardView const& view, double bound) {
  Components const x = components_of(view.store, Field::position);
  std::map<std::size_t, double> deepest;
  for (std::size_t n = 0; n < view.search.wet_walls().size(); ++n)
    for_each_inside(view, x, bound, n, [&](std::size_t particle, double found) {
      deepest[particle] = std::max(deepest[particle], found);
    });
  std::vector<Suspect> suspects;
  for (auto const& [particle, found] : deepest) suspects.push_back({particle, found});
  return suspects;
}

}  // namespace moraine
