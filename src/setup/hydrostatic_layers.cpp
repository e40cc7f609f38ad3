#include "setup/hydrostatic_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace moraine {
namespace {

using ColumnPlace = std::array<std::int64_t, 3>;  // lattice indices, 0 along the vertical

// Lattice coordinates of seeds: which column they are in, and which layer, counted upwards.
class Layering {
 public:
  Layering(Case const& c, Lattice const& lattice, Vertical vertical)
      : vertical_(vertical),
        dimension_(static_cast<std::size_t>(c.dimension)),
        spacing_(lattice.spacing),
        anchor_(lattice.origin) {}

  std::pair<ColumnPlace, std::int64_t> place_of(Seed const& seed) const {
    ColumnPlace place{};
    for (std::size_t axis = 0; axis < dimension_; ++axis)
      place[axis] = std::llround((seed.position[axis] - anchor_[axis]) / spacing_ - 0.5);
    std::int64_t const layer = vertical_.up * place[vertical_.axis];
    place[vertical_.axis] = 0;
    return {place, layer};
  }
  double height(Seed const& seed) const { return vertical_.up * seed.position[vertical_.axis]; }
  double spacing() const { return spacing_; }

 private:
  Vertical vertical_;
  std::size_t dimension_;
  double spacing_;
  Point anchor_;
};

// Whether all columns reach unbroken from the same layer to their free surface.
bool stand_free(std::vector<Seed> const& seeds, std::span<std::size_t const> layered, Case const& c,
                Layering const& layering) {
  struct Column {
    std::int64_t lowest, highest, count;
    double gap;  // m, from the highest particle to the level
  };
  std::map<ColumnPlace, Column> columns;
  for (std::size_t const k : layered) {
    Seed const& seed = seeds[k];
    auto const [place, layer] = layering.place_of(seed);
    double const level = *c.regions[seed.region].initial.hydrostatic_level;
    double const gap = level - layering.height(seed);
    auto const [found, fresh] = columns.try_emplace(place, Column{layer, layer, 0, gap});
    Column& column = found->second;
    column.lowest = std::min(column.lowest, layer);
    if (layer >= column.highest) {
      column.highest = layer;
      column.gap = gap;
    }
    ++column.count;
  }
  std::int64_t const floor = columns.begin()->second.lowest;
  return std::all_of(columns.begin(), columns.end(), [&](auto const& entry) {
    Column const& column = entry.second;
    return column.lowest == floor && column.count == column.highest - column.lowest + 1 &&
           column.gap < 1.5 * layering.spacing();
  });
}

}  // namespace

std::optional<Vertical> vertical_of(Point const& gravity) {
  std::optional<Vertical> vertical;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (gravity[axis] == 0.0) continue;
    if (vertical) return std::nullopt;
    vertical = Vertical{axis, gravity[axis] < 0.0 ? +1 : -1};
  }
  return vertical;
}

void compress_layers(std::vector<Seed>& seeds, std::span<std::size_t const> layered, Case const& c,
                     Lattice const& lattice, Vertical vertical) {
  Layering const layering(c, lattice, vertical);
  if (layered.empty() || !stand_free(seeds, layered, c, layering)) return;
  double const spacing = lattice.spacing;
  double const area = std::pow(spacing, c.dimension - 1);  // of a particle seen from above
  std::map<ColumnPlace, double> tops;                      // m, filled so far, upwards
  // Along every axis fill_regions goes towards larger coordinates; columns are filled from below.
  for (std::size_t k = 0; k < layered.size(); ++k) {
    Seed& seed = seeds[layered[vertical.up > 0 ? k : layered.size() - 1 - k]];
    double const bottom = layering.height(seed) - 0.5 * spacing;
    double& top = tops.try_emplace(layering.place_of(seed).first, bottom).first->second;
    seed.mass = reference_density(c.materials[seed.material].eos) * lattice.volume;
    double const thickness = seed.mass / (seed.density * area);
    seed.position[vertical.axis] = vertical.up * (top + 0.5 * thickness);
    top += thickness;
  }
}

}  // namespace moraine
