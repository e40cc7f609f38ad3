// Images at the sides of the domain, and particles that have passed a side.
#include <cmath>

#include "search/search.hpp"

namespace moraine {

/// Where an image would be inside of the domain now, the particle changes places with it.
void Search::bring_back(ParticleStore& store, Kind kind) {
  DomainSides const& sides = settings_.sides;
  Range const range = store.range(kind);
  for (int axis = 0; axis < settings_.dimension; ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    auto position = store.component(Field::position, axis);
    if (sides.periodic[k])
      for (std::size_t i = range.begin; i < range.end; ++i) {
        double const periods = std::floor((position[i] - sides.low[k]) / sides.length[k]);
        position[i] -= periods * sides.length[k];
      }
    if (sides.reflects(k) && kind == Kind::fluid) swap_with_images(store, k);
  }
}

/// Particles beyond planes come back as their images. At a no-slip wall too only what points across
/// the wall is reversed: it is the particle that comes back, not its image.
void Search::swap_with_images(ParticleStore& store, std::size_t axis) {
  DomainSides const& sides = settings_.sides;
  Range const range = store.range(Kind::fluid);
  auto position = store.component(Field::position, static_cast<int>(axis));
  auto velocity = store.component(Field::velocity, static_cast<int>(axis));
  auto acceleration = store.component(Field::acceleration, static_cast<int>(axis));
  for (std::size_t i = range.begin; i < range.end; ++i) {
    bool const below = sides.reflects(axis, 0) && position[i] < sides.low[axis];
    bool const above =
        sides.reflects(axis, 1) && position[i] > sides.low[axis] + sides.length[axis];
    if (!below && !above) continue;
    position[i] = sides.image_place(position[i], below ? -1 : +1, axis);
    velocity[i] *= -1.0;
    acceleration[i] *= -1.0;
    ++reflections_.count;
    if (sides.is_wall(axis, below ? 0 : 1))
      reflections_.impulse[axis] += 2.0 * store.scalar(Field::mass)[i] * velocity[i];
  }
}

/// Makes the images of a kind and sorts them in among its owned points.
void Search::mix_images(ParticleStore const& store, Kind kind) {
  Points& p = points(kind);
  Range const range = store.range(kind);
  auto const id = store.id().subspan(range.begin, range.size());
  auto const dimension = static_cast<std::size_t>(settings_.dimension);
  auto& [x, key] = mixing_;
  key.assign(id.begin(), id.end());
  UnitSpans const owned = p.spans();
  for (std::size_t axis = 0; axis < dimension; ++axis)
    x[axis].assign(owned[axis].begin(), owned[axis].end());
  append_images(settings_.sides, settings_.dimension, static_cast<std::int64_t>(reach()) + 2, x,
                key, p.images);
  p.at_wall.clear();
  if (settings_.sides.any_wall())
    for (Image const& image : p.images) p.at_wall.push_back(settings_.sides.at_wall(image) ? 1 : 0);
  auto const order =
      sort_by_cells_(GridShape(p.grid.shape), settings_.dimension, {x[0], x[1], x[2]}, key, p.grid);
  if (!p.support.empty()) {
    p.mixed_support.resize(order.size() + CellPoints::padding);
    for (std::size_t k = 0; k < order.size(); ++k)
      p.mixed_support[k] =
          p.support[order[k] < p.owned ? order[k] : p.images[order[k] - p.owned].source];
  }
  p.mixed_index.assign(order.begin(), order.end());
  p.mixed_index.resize(order.size() + CellPoints::padding);
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    p.mixed_x[axis].resize(order.size() + CellPoints::padding);
    for (std::size_t k = 0; k < order.size(); ++k) p.mixed_x[axis][k] = x[axis][order[k]];
  }
}

}  // namespace moraine
