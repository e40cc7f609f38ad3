#include "search/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"

namespace moraine {
namespace {

// Cost of a rebuild (sort, lists) in units of one pair sweep: measured 0.6 in 2D and 3D.
constexpr double rebuild_cost = 0.6;
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
    seen_ = now;
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

void Search::sort(ParticleStore& store) {
  order_.resize(store.size());
  std::size_t at = 0;
  for (Kind const kind : {Kind::fluid, Kind::wall}) {
    Range const range = store.range(kind);
    CellGrid& grid = points(kind).grid;
    for (std::size_t k = 0; k < range.size(); ++k)
      order_[at++] = static_cast<std::uint32_t>(range.begin + grid.entry[k]);
  }
  store.permute(order_);
}

void Search::rebuild(ParticleStore& store) {
  int const dimension = settings_.dimension;
  double const scale = settings_.fixed_point.scale;
  double const longest = settings_.support + std::max(skins_.fluid, skins_.wall);
  if (settings_.periodicity.any()) wrap(store);
  read_units(store, Kind::fluid);
  read_units(store, Kind::wall);

  UnitPoint low, high;
  low.fill(std::numeric_limits<Units>::max());
  high.fill(std::numeric_limits<Units>::min());
  auto const reach = static_cast<Units>(longest / scale) + 2;
  for (Points const& p : points_)
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
      for (Units const x : p.x[axis]) {
        low[axis] = std::min(low[axis], x);
        high[axis] = std::max(high[axis], x);
      }
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    if (!settings_.periodicity.periodic[axis]) continue;
    low[axis] -= reach;
    high[axis] += reach;
  }
  GridShape const shape = GridShape::over(low, high, dimension, longest / scale / cells_per_radius,
                                          4 * store.size() + 4096);

  auto const fill = [&](Kind kind) {
    Points& p = points(kind);
    Range const range = store.range(kind);
    auto const id = store.id().subspan(range.begin, range.size());
    p.key.assign(id.begin(), id.end());
    p.images.clear();
    p.grid.fill(shape, dimension, p.spans(), p.key);
  };
  fill(Kind::fluid);
  fill(Kind::wall);
  sort(store);
  for (Kind const kind : {Kind::fluid, Kind::wall}) {
    // The store is in cell order; the grid now needs the new indices, and images if there are any.
    read_units(store, kind);
    Points& p = points(kind);
    Range const range = store.range(kind);
    auto const id = store.id().subspan(range.begin, range.size());
    p.key.assign(id.begin(), id.end());
    if (settings_.periodicity.any()) {
      append_images(settings_.periodicity, dimension, reach, p.x, p.key, p.images);
      p.grid.fill(shape, dimension, p.spans(), p.key);
    } else {
      for (std::size_t k = 0; k < range.size(); ++k) p.grid.entry[k] = static_cast<std::uint32_t>(k);
    }
  }
  displacement_.reset(points(Kind::fluid).grid, points(Kind::wall).grid,
                      store.range(Kind::fluid).size(), longest / scale,
                      !settings_.periodicity.any(), points(Kind::fluid).spans());
  if (dimension == 1) make_lists<1>();
  if (dimension == 2) make_lists<2>();
  if (dimension == 3) make_lists<3>();
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
  auto const at = [](Points const& p, std::size_t i) {
    UnitPoint x{};
    for (std::size_t axis = 0; axis < D; ++axis) x[axis] = p.x[axis][i];
    return x;
  };
  auto const nowhere = [](Points const& p) { return static_cast<std::uint32_t>(p.key.size()); };
  std::size_t const fluids = fluid.key.size() - fluid.images.size();
  std::size_t const walls = wall.key.size() - wall.images.size();

  RowCollector<D> const near_fluid(fluid.grid, fluid_radius);
  fluid_fluid_.build(fluids, nowhere(fluid), [&](std::size_t i, IndexBuffer& buffer) {
    near_fluid(at(fluid, i), static_cast<std::uint32_t>(i), buffer);
  });
  RowCollector<D> const near_wall(wall.grid, wall_radius);
  fluid_wall_.build(fluids, nowhere(wall), [&](std::size_t i, IndexBuffer& buffer) {
    UnitPoint const x = at(fluid, i);
    if (walls > 0 && displacement_.near_wall(x)) near_wall(x, nobody, buffer);
  });
  RowCollector<D> const wall_near_fluid(fluid.grid, wall_radius);
  wall_fluid_.build(walls, nowhere(fluid), [&](std::size_t i, IndexBuffer& buffer) {
    wall_near_fluid(at(wall, i), nobody, buffer);
  });
}

std::size_t Search::bytes() const {
  std::size_t sum = fluid_fluid_.bytes() + fluid_wall_.bytes() + wall_fluid_.bytes() +
                    displacement_.bytes() + order_.capacity() * sizeof(std::uint32_t);
  for (Points const& p : points_) {
    sum += p.grid.bytes() + p.key.capacity() * sizeof(std::uint64_t) +
           p.images.capacity() * sizeof(Image);
    for (auto const& axis : p.x) sum += axis.capacity() * sizeof(Units);
  }
  return sum;
}

}  // namespace moraine
