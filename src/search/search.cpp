#include "search/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

void Search::read_units(ParticleStore const& store, Kind kind) {
  Range const range = store.range(kind);
  auto& x = points(kind).x;
  for (int axis = 0; axis < settings_.dimension; ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    auto const position = store.component(Field::position, axis);
    x[k].resize(range.size());
    double const center = settings_.fixed_point.center[k];
    double const inverse = 1.0 / settings_.fixed_point.scale;
    for_each_block(range.size(), loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        x[k][i] = static_cast<Units>(std::lrint((position[range.begin + i] - center) * inverse));
    });
  }
}

bool Search::refresh(ParticleStore& store) {
  read_units(store, Kind::fluid);
  Points const& fluid = points(Kind::fluid);
  if (rebuilds_ > 0 && store.range(Kind::fluid).size() == fluid_fluid_.size()) {
    auto const now = displacement_.largest(fluid.spans());
    ++steps_since_rebuild_;
    double const scale = settings_.fixed_point.scale;
    // The box of a displacement is exact in units; one part in a thousand covers its rounding.
    if (now.fluid * scale < 0.999 * skins_.fluid && now.wall * scale < 0.999 * skins_.wall) {
      seen_ = now;
      return false;
    }
    if (std::isfinite(now.fluid)) seen_ = now;
    choose_skins();
  }
  rebuild(store);
  return true;
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

void Search::wrap(ParticleStore& store) const {
  Periodicity const& sides = settings_.periodicity;
  Range const fluid = store.range(Kind::fluid);
  for (int axis = 0; axis < settings_.dimension; ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    if (!sides.periodic[k]) continue;
    auto position = store.component(Field::position, axis);
    for (std::size_t i = fluid.begin; i < fluid.end; ++i) {
      double const periods = std::floor((position[i] - sides.low[k]) / sides.period[k]);
      position[i] -= periods * sides.period[k];
    }
  }
}

void Search::fill(ParticleStore const& store, Kind kind, GridShape const& shape) {
  Points& p = points(kind);
  Range const range = store.range(kind);
  auto const id = store.id().subspan(range.begin, range.size());
  p.key.assign(id.begin(), id.end());
  p.grid.fill(shape, settings_.dimension, p.spans(), p.key);
}

void Search::sort(ParticleStore& store, bool walls) {
  order_.resize(store.size());
  std::iota(order_.begin(), order_.end(), 0u);
  for (Kind const kind : {Kind::fluid, Kind::wall}) {
    if (kind == Kind::wall && !walls) continue;
    Range const range = store.range(kind);
    CellGrid& grid = points(kind).grid;
    for (std::size_t k = 0; k < range.size(); ++k)
      order_[range.begin + k] = static_cast<std::uint32_t>(range.begin + grid.entry[k]);
  }
  store.permute(order_, walls ? store.size() : store.range(Kind::fluid).size());
}

/// Grids of both kinds, the store in their order, and images. Walls at rest are sorted once.
void Search::sort_points(ParticleStore& store, double reach) {
  bool const walls = rebuilds_ == 0;
  std::size_t const dimension = static_cast<std::size_t>(settings_.dimension);
  auto const shape = [&](Kind kind) {
    UnitPoint low, high;
    low.fill(std::numeric_limits<Units>::max());
    high.fill(std::numeric_limits<Units>::min());
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      for (Units const x : points(kind).x[axis]) {
        low[axis] = std::min(low[axis], x);
        high[axis] = std::max(high[axis], x);
      }
      Periodicity const& sides = settings_.periodicity;
      if (!sides.periodic[axis]) continue;
      // Images lie beyond the sides, wherever the points themselves are.
      auto const upper = static_cast<Units>(sides.low_units[axis] + sides.period_units[axis]);
      low[axis] = std::min(low[axis], sides.low_units[axis]) - static_cast<Units>(reach);
      high[axis] = std::max(high[axis], upper) + static_cast<Units>(reach);
    }
    // A hair larger than the fraction of the radius, so that rounding never costs a further cell.
    double const edge = 1.00001 * reach / cells_per_radius + 8.0;
    return GridShape::over(low, high, settings_.dimension, edge, 4 * store.size() + 4096);
  };
  for (Kind const kind : {Kind::fluid, Kind::wall}) {
    if ((kind == Kind::wall && !walls) || store.range(kind).size() == 0) continue;
    read_units(store, kind);
    fill(store, kind, shape(kind));
  }
  sort(store, walls);
  for (Kind const kind : {Kind::fluid, Kind::wall}) {
    Points& p = points(kind);
    bool const images = settings_.periodicity.any();
    if ((kind == Kind::wall && !walls && !images) || store.range(kind).size() == 0) continue;
    // The store is in cell order now: entry k is point k, and images come behind.
    read_units(store, kind);
    GridShape const grid = p.grid.shape;
    std::iota(p.grid.entry.begin(), p.grid.entry.end(), 0u);
    if (!images) continue;
    fill(store, kind, grid);
    append_images(settings_.periodicity, settings_.dimension, static_cast<std::int64_t>(reach) + 2,
                  p.x, p.key, p.images);
    p.grid.fill(grid, settings_.dimension, p.spans(), p.key);
  }
}

void Search::rebuild(ParticleStore& store) {
  double const reach =
      (settings_.support + std::max(skins_.fluid, skins_.wall)) / settings_.fixed_point.scale;
  if (settings_.periodicity.any()) wrap(store);
  sort_points(store, reach);
  displacement_.reset(points(Kind::fluid).grid, points(Kind::wall).grid,
                      store.range(Kind::fluid).size(), reach, !settings_.periodicity.any(),
                      points(Kind::fluid).spans());
  if (settings_.dimension == 1) make_lists<1>();
  if (settings_.dimension == 2) make_lists<2>();
  if (settings_.dimension == 3) make_lists<3>();
  steps_since_rebuild_ = 0;
  ++rebuilds_;
}

template <int D>
void Search::make_lists() {
  Points const& fluid = points(Kind::fluid);
  Points const& wall = points(Kind::wall);
  double const scale = settings_.fixed_point.scale;
  double const fluid_radius = (settings_.support + skins_.fluid) / scale;
  double const wall_radius = (settings_.support + skins_.wall) / scale;
  constexpr std::uint32_t nobody = 0xFFFFFFFFu;
  constexpr std::size_t lanes = NeighbourList::lanes(D);
  bool const unsorted = settings_.periodicity.any();  // images stand among the owned points
  auto const at = [](Points const& p, std::size_t i) {
    UnitPoint x{};
    for (std::size_t axis = 0; axis < D; ++axis) x[axis] = p.x[axis][i];
    return x;
  };
  std::size_t const fluids = fluid.key.size() - fluid.images.size();
  std::size_t const walls = wall.key.size() - wall.images.size();

  NeighbourFinder<D> const near_fluid(fluid.grid, fluid_radius);
  fluid_fluid_.build(fluids, lanes, unsorted,
                     [&](std::size_t i, CandidateCache& cache, IndexBuffer& buffer) {
                       near_fluid(at(fluid, i), static_cast<std::uint32_t>(i), cache, buffer);
                     });
  NeighbourFinder<D> const near_wall(wall.grid, wall_radius);
  fluid_wall_.build(fluids, lanes, unsorted,
                    [&](std::size_t i, CandidateCache& cache, IndexBuffer& buffer) {
                      UnitPoint const x = at(fluid, i);
                      if (walls > 0 && displacement_.near_wall(x))
                        near_wall(x, nobody, cache, buffer);
                    });
  NeighbourFinder<D> const wall_near_fluid(fluid.grid, wall_radius);
  wall_fluid_.build(walls, lanes, unsorted,
                    [&](std::size_t i, CandidateCache& cache, IndexBuffer& buffer) {
                      UnitPoint const x = at(wall, i);
                      if (displacement_.near_fluid(x)) wall_near_fluid(x, nobody, cache, buffer);
                    });
  wet_walls_.clear();
  for (std::size_t i = 0; i < walls; ++i)
    if (!wall_fluid_.of(i).empty()) wet_walls_.push_back(static_cast<std::uint32_t>(i));
}

std::size_t Search::bytes() const {
  std::size_t sum = fluid_fluid_.bytes() + fluid_wall_.bytes() + wall_fluid_.bytes() +
                    displacement_.bytes() +
                    (order_.capacity() + wet_walls_.capacity()) * sizeof(std::uint32_t);
  for (Points const& p : points_) {
    sum += p.grid.bytes() + p.key.capacity() * sizeof(std::uint64_t) +
           p.images.capacity() * sizeof(Image);
    for (auto const& axis : p.x) sum += axis.capacity() * sizeof(Units);
  }
  return sum;
}

}  // namespace moraine
