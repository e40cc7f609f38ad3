// What a search saves, and how it comes back.
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "search/search.hpp"

namespace moraine {

void Search::exchange(Archive& archive, ParticleStore& store) {
  archive.number("search/fluid_skin", skins_.fluid);
  archive.number("search/wall_skin", skins_.wall);
  archive.number("search/wall_reach", wall_reach_);
  archive.number("search/fluid_motion_seen", seen_.fluid);
  archive.number("search/wall_motion_seen", seen_.wall);
  archive.number("search/steps_since_rebuild", steps_since_rebuild_);
  archive.number("search/rebuilds", rebuilds_);
  archive.number("search/reflections", reflections_.count);
  for (std::size_t axis = 0; axis < 3; ++axis)
    archive.number(std::string("search/reflected_impulse_") + "xyz"[axis],
                   reflections_.impulse[axis]);
  if (archive.restoring()) points(Kind::wall) = {};
  exchange_reference(archive, store, Kind::fluid);
  if (settings_.walls_move) exchange_reference(archive, store, Kind::wall);
  if (varies()) exchange_supports(archive, store);
  if (!archive.restoring()) return;
  walls_sorted_ = true;
  if (store.range(Kind::wall).size() > 0) {
    if (!settings_.walls_move) read_units(store, Kind::wall);
    expect_order(store, Kind::wall, wall_reach_);
  }
  expect_order(store, Kind::fluid, reach());
  make_lists(store);
  read_units(store, Kind::fluid);
  read_supports(store);
  if (settings_.walls_move) read_units(store, Kind::wall);
  displacement_.largest(moving_points());
}

/// Saves or restores where the points of a kind were when the lists were made.
void Search::exchange_reference(Archive& archive, ParticleStore const& store, Kind kind) {
  Points& p = points(kind);
  std::string const name = kind == Kind::fluid ? "search/listed_at_" : "search/walls_listed_at_";
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(settings_.dimension); ++axis) {
    auto const reference = displacement_.reference(kind, axis);
    std::vector<Units> units(reference.begin(), reference.end());
    archive.array(name + "xyz"[axis], "", units);
    if (!archive.restoring()) continue;
    if (units.size() != store.range(kind).size())
      throw std::runtime_error("search and particles do not belong together");
    units.resize(units.size() + CellPoints::padding);
    p.owned = store.range(kind).size();
    p.x[axis] = std::move(units);
  }
}

/// Saves or restores the supports that the lists were made for.
void Search::exchange_supports(Archive& archive, ParticleStore const& store) {
  archive.number("search/largest_support", largest_support_);
  std::vector<double> listed(listed_support_.begin(), listed_support_.end());
  archive.array("search/listed_supports", "", listed);
  if (!archive.restoring()) return;
  if (listed.size() != store.range(Kind::fluid).size())
    throw std::runtime_error("search and particles do not belong together");
  listed_support_.assign(listed.begin(), listed.end());
  auto& support = points(Kind::fluid).support;
  support = listed_support_;
  support.resize(support.size() + CellPoints::padding);
}

/// Makes the grid of points that are in cell order already.
void Search::expect_order(ParticleStore const& store, Kind kind, double reach) {
  auto const order = cell_order(store, kind, reach);
  for (std::size_t k = 0; k < order.size(); ++k)
    if (order[k] != k) throw std::runtime_error("the particles are not in the order of the search");
}

}  // namespace moraine
