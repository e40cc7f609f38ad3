// Images at the sides of the domain, and particles that have passed a side.
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/parallel_for.hpp"
#include "search/search.hpp"

namespace moraine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Components of particle fields that change their sign where an axis is reflected: those with this
/// axis an odd number of times among their own.
class OddComponents {
 public:
  OddComponents(ParticleStore& store, std::size_t axis) {
    for (FieldInfo const& field : field_table)
      if (field.field != Field::position && store.has(field.field)) add(store, field, axis);
  }

  void reverse(std::size_t i) const {
    for (std::size_t k = 0; k < count_; ++k) components_[k][i] *= -1.0;
  }

 private:
  void add(ParticleStore& store, FieldInfo const& field, std::size_t axis) {
    auto const d = static_cast<std::size_t>(store.dimension());
    auto const take = [&](std::size_t component) {
      components_[count_++] = store.component(field.field, static_cast<int>(component));
    };
    if (field.rank == Rank::vector) take(axis);
    for (std::size_t other = 0; other < d; ++other) {
      if (other == axis) continue;
      if (field.rank == Rank::symmetric) take(d + axis + other - 1);  // base/symmetric.hpp
      if (field.rank == Rank::matrix) take(axis * d + other);
      if (field.rank == Rank::matrix) take(other * d + axis);
    }
  }

  std::array<std::span<double>, 2 * field_count> components_{};
  std::size_t count_ = 0;
};

}  // namespace

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

/// Particles beyond planes of an axis come back as their images. At a no-slip wall too only what
/// points across the wall is reversed: it is the particle that comes back, not its image.
void Search::swap_with_images(ParticleStore& store, std::size_t axis) {
  DomainSides const& sides = settings_.sides;
  auto position = store.component(Field::position, static_cast<int>(axis));
  auto const velocity = store.component(Field::velocity, static_cast<int>(axis));
  OddComponents const odd(store, axis);
  auto const mass = store.scalar(Field::mass);
  double const low = sides.reflects(axis, 0) ? sides.low[axis] : -infinity;
  double const high = sides.reflects(axis, 1) ? sides.low[axis] + sides.length[axis] : infinity;
  auto const of_block = [&](std::size_t begin, std::size_t end) {
    Reflections sum;
    for (std::size_t i = begin; i < end; ++i) {
      if (position[i] >= low && position[i] <= high) continue;
      bool const below = position[i] < low;
      if (!below && !(position[i] > high)) continue;  // no number
      position[i] = sides.image_place(position[i], below ? -1 : +1, axis);
      odd.reverse(i);
      ++sum.count;
      if (sides.is_wall(axis, below ? 0 : 1)) sum.impulse[axis] += 2.0 * mass[i] * velocity[i];
    }
    return sum;
  };
  auto const add = [](Reflections a, Reflections const& b) {
    a.count += b.count;
    for (std::size_t k = 0; k < 3; ++k) a.impulse[k] += b.impulse[k];
    return a;
  };
  reflections_ = add(reflections_,
                     reduce_blocks(store.range(Kind::fluid).size(), Reflections{}, of_block, add));
}

void Search::return_from_walls(ParticleStore& store) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(settings_.dimension); ++axis)
    if (settings_.sides.is_wall(axis, 0) || settings_.sides.is_wall(axis, 1))
      swap_with_images(store, axis);
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
