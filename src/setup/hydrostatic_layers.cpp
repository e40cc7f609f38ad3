#include "setup/hydrostatic_layers.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "setup/lattice.hpp"

namespace moraine {
namespace {

// The part of a column that is filled so far.
struct Column {
  std::int64_t layer;  // the highest, counted upwards
  double top;          // m, its upper face, upwards
};

class Stack {
 public:
  Stack(Case const& c, Vertical vertical)
      : vertical_(vertical),
        dimension_(static_cast<std::size_t>(c.dimension)),
        spacing_(c.numerics.spacing),
        area_(std::pow(spacing_, c.dimension - 1)),
        anchor_(lattice_anchor(c)) {}

  // Particles of a column come from below.
  void add(Seed& seed) {
    std::array<std::int64_t, 3> place{};
    for (std::size_t axis = 0; axis < dimension_; ++axis)
      place[axis] = std::llround((seed.position[axis] - anchor_[axis]) / spacing_ - 0.5);
    std::int64_t const layer = vertical_.up * place[vertical_.axis];
    place[vertical_.axis] = 0;
    double const height = vertical_.up * seed.position[vertical_.axis];
    auto const [found, fresh] = columns_.try_emplace(place);
    Column& column = found->second;
    if (fresh || column.layer + 1 != layer) column.top = height - 0.5 * spacing_;
    double const thickness = seed.mass / (seed.density * area_);
    seed.position[vertical_.axis] = vertical_.up * (column.top + 0.5 * thickness);
    column = {layer, column.top + thickness};
  }

 private:
  Vertical vertical_;
  std::size_t dimension_;
  double spacing_;
  double area_;  // m^(dimension - 1), of a particle seen from above
  Point anchor_;
  std::map<std::array<std::int64_t, 3>, Column> columns_;
};

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
                     Vertical vertical) {
  // Along every axis fill_regions goes towards larger coordinates.
  Stack stack(c, vertical);
  std::size_t const count = layered.size();
  for (std::size_t k = 0; k < count; ++k)
    stack.add(seeds[layered[vertical.up > 0 ? k : count - 1 - k]]);
}

}  // namespace moraine
