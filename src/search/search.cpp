#include "search/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"

namespace moraine {
namespace {

// Cost of a rebuild (sort, lists, cold caches) in units of one pair sweep. Measured about 2 in 3D;
// the optimum is flat, and the smaller value keeps the lists shorter.
constexpr double rebuild_cost = 1.0;
// Share of a sweep's pairs that have a wall neighbour: typical of tanks; only tunes the skins.
constexpr double wall_share = 0.15;
// Bounds of a skin in supports: below, rounding; above, lists full of pairs out of reach.
constexpr double least_skin = 0.005;
constexpr double most_skin = 0.25;
constexpr double first_skin = 0.04;
// Cells per list radius: short rows fit the sphere better, long rows fill the SIMD lanes.
constexpr double cells_per_radius = 2.0;

}  // namespace

Search::Search(SearchSettings const& settings) : settings_(settings) {
  skins_ = {first_skin * settings.support, first_skin * settings.support};
}

UnitSpans Search::Points::spans() const {
  UnitSpans spans;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!x[axis].empty()) spans[axis] = {x[axis].data(), owned};
  return spans;
}

CellPoints Search::Points::in_cells() const {
  if (images.empty()) return {grid, spans(), {}, support};
  return {grid, {mixed_x[0], mixed_x[1], mixed_x[2]}, mixed_index, mixed_support};
}

void Search::read_units(ParticleStore const& store, Kind kind) {
  Range const range = store.range(kind);
  Points& p = points(kind);
  p.owned = range.size();
  // The fixed-point box reaches twice the support beyond the domain. Whatever lies farther outside,
  // or is no number, is put on its face: it has moved too far for the lists, and what decides about
  // them cannot overflow.
  constexpr double face = 1073741823.0;
  for (int axis = 0; axis < settings_.dimension; ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    auto const position = store.component(Field::position, axis);
    auto& x = p.x[k];
    x.resize(range.size() + CellPoints::padding);
    double const center = settings_.fixed_point.center[k];
    double const inverse = 1.0 / settings_.fixed_point.scale;
    for_each_block(range.size(), loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double const exact = (position[range.begin + i] - center) * inverse;
        double const low = exact > -face ? exact : -face;
        x[i] = static_cast<Units>(std::lrint(low < face ? low : face));
      }
    });
  }
}

bool Search::lists_hold(ParticleStore const& store) {
  if (!walls_sorted_ || store.range(Kind::fluid).size() != fluid_fluid_.size()) return false;
  read_units(store, Kind::fluid);
  if (settings_.walls_move) read_units(store, Kind::wall);
  read_supports(store);
  auto now = displacement_.largest(moving_points());
  double const growth = growth_of_supports();
  now.fluid += growth;
  now.wall += growth;
  ++steps_since_rebuild_;
  double const scale = settings_.fixed_point.scale;
  if (std::isfinite(now.fluid)) seen_ = now;
  // The box of a displacement is exact in units; one part in a thousand covers its rounding.
  return now.fluid * scale < 0.999 * skins_.fluid && now.wall * scale < 0.999 * skins_.wall;
}

void Search::choose_skins() {
  double const scale = settings_.fixed_point.scale / settings_.support;
  double const steps = static_cast<double>(steps_since_rebuild_);
  double const fluid_rate = seen_.fluid * scale / steps;  // supports per step
  double const wall_rate = seen_.wall * scale / steps;
  // Cost per step for a life of L steps: 3 L (rate) longer lists + rebuild_cost / L.
  double const growth =
      static_cast<double>(settings_.dimension) * (fluid_rate + wall_share * wall_rate);
  double const life = std::clamp(std::sqrt(rebuild_cost / std::max(growth, 1e-12)), 2.0, 100.0);
  auto const skin = [&](double rate) {
    return std::clamp(1.1 * life * rate, least_skin, most_skin) * settings_.support;
  };
  skins_ = {skin(fluid_rate), skin(wall_rate)};
}

MovingPoints Search::moving_points() const {
  return {points(Kind::fluid).spans(),
          settings_.walls_move ? points(Kind::wall).spans() : UnitSpans{}};
}

/// A grid over all points of a kind and their images within the reach [units].
GridShape Search::shape_around(Kind kind, double reach) const {
  UnitPoint low, high;
  low.fill(std::numeric_limits<Units>::max());
  high.fill(std::numeric_limits<Units>::min());
  UnitSpans const x = points(kind).spans();
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(settings_.dimension); ++axis) {
    for (Units const value : x[axis]) {
      low[axis] = std::min(low[axis], value);
      high[axis] = std::max(high[axis], value);
    }
    // Images lie beyond the sides, wherever the points themselves are.
    DomainSides const& sides = settings_.sides;
    auto const lower = sides.low_units[axis];
    auto const upper = static_cast<Units>(lower + sides.length_units[axis]);
    if (sides.periodic[axis] || sides.reflects(axis, 0))
      low[axis] = std::min(low[axis], lower) - static_cast<Units>(reach);
    if (sides.periodic[axis] || sides.reflects(axis, 1))
      high[axis] = std::max(high[axis], upper) + static_cast<Units>(reach);
  }
  // A hair larger than the fraction of the radius, so that rounding never costs a further cell.
  double const edge = 1.00001 * reach / cells_per_radius + 8.0;
  // A function of this kind alone: a restored run sorts its walls when the fluid is known already,
  // and must come to the same cells.
  std::size_t const most_cells = 8 * points(kind).owned + (std::size_t{1} << 18);
  return GridShape::over(low, high, settings_.dimension, edge, most_cells);
}

/// The order of a kind's particles by cells and ids; makes the grid.
std::span<std::uint32_t const> Search::cell_order(ParticleStore const& store, Kind kind,
                                                  double reach) {
  Points& p = points(kind);
  Range const range = store.range(kind);
  auto const id = store.id().subspan(range.begin, range.size());
  return sort_by_cells_(shape_around(kind, reach), settings_.dimension, p.spans(), id, p.grid);
}

/// Puts the particles of a kind into cell order, in the store and here.
void Search::sort(ParticleStore& store, Kind kind, double reach) {
  store.permute(kind, cell_order(store, kind, reach));
  read_units(store, kind);
  if (kind == Kind::fluid) list_supports(store);
}

double Search::reach() const {
  double const of_case = settings_.support / settings_.fixed_point.scale;
  double const support = varies() ? std::max(largest_support_, of_case) : of_case;
  return support + std::max(skins_.fluid, skins_.wall) / settings_.fixed_point.scale;
}

void Search::rebuild(ParticleStore& store) {
  if (steps_since_rebuild_ > 0) choose_skins();
  if (settings_.sides.any()) {
    bring_back(store, Kind::fluid);
    if (settings_.walls_move) bring_back(store, Kind::wall);
  }
  find_largest_support(store);
  if (!walls_sorted_ || settings_.walls_move) {
    wall_reach_ = reach();
    sort_walls(store);
  }
  read_units(store, Kind::fluid);
  sort(store, Kind::fluid, reach());
  make_lists(store);
  steps_since_rebuild_ = 0;
  ++rebuilds_;
}

/// Walls at rest are sorted once; what that took is given back.
void Search::sort_walls(ParticleStore& store) {
  walls_sorted_ = true;
  points(Kind::wall) = {};
  if (store.range(Kind::wall).size() == 0) return;
  read_units(store, Kind::wall);
  sort(store, Kind::wall, wall_reach_);
  if (settings_.walls_move) return;
  store.shrink();
  sort_by_cells_ = {};
}

std::size_t Search::bytes() const {
  std::size_t sum = mixing_.key.capacity() * sizeof(std::uint64_t) + fluid_fluid_.bytes() +
                    fluid_mirrored_.bytes() + fluid_wall_.bytes() + wall_fluid_.bytes() +
                    displacement_.bytes() + sort_by_cells_.bytes() +
                    wet_walls_.capacity() * sizeof(std::uint32_t) +
                    listed_support_.capacity() * sizeof(float);
  for (auto const& axis : mixing_.x) sum += axis.capacity() * sizeof(Units);
  for (Points const& p : points_) {
    sum += p.grid.bytes() + p.images.capacity() * sizeof(Image) + p.at_wall.capacity() +
           (p.support.capacity() + p.mixed_support.capacity()) * sizeof(float) +
           p.mixed_index.capacity() * sizeof(std::uint32_t);
    for (auto const* arrays : {&p.x, &p.mixed_x})
      for (auto const& axis : *arrays) sum += axis.capacity() * sizeof(Units);
  }
  return sum;
}

}  // namespace moraine
