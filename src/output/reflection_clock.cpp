#include "output/reflection_clock.hpp"

#include <algorithm>
#include <cmath>

namespace moraine {
namespace {

/// Whether a place lies behind an end that absorbs.
bool is_absorbed(AbsorbingLayers const& layers, Vec3 const& place) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const& [low, high] = layers.ends[axis];
    if ((low && place[axis] < *low) || (high && place[axis] > *high)) return true;
  }
  return false;
}

}  // namespace

void ReflectionClock::tell(Model const& model, double time) {
  ParticleStore const& store = model.particles;
  Range const walls = store.range(Kind::wall);
  bool const begins = first_.empty();
  if (begins) {
    first_.assign(model.walls.points.size(), 0.0);
    has_seen_.assign(first_.size(), 0);
  }
  auto const pressure = store.scalar(Field::pressure);
  auto const sound_speed = store.scalar(Field::sound_speed);
  for (std::size_t k = walls.begin; k < walls.end; ++k) {
    std::size_t const w = store.id()[k] - model.walls.first_id;
    if (begins) first_[w] = pressure[k];
    if (has_seen_[w] != 0 || pressure[k] - first_[w] < rise_ || !(sound_speed[k] > 0.0)) continue;
    has_seen_[w] = 1;
    Vec3 place{};
    for (int axis = 0; axis < model.dimension; ++axis)
      place[static_cast<std::size_t>(axis)] = store.component(Field::position, axis)[k];
    if (is_absorbed(model.absorbing, place)) continue;
    for (std::size_t n = 0; n < places_.size(); ++n)
      earliest_[n] =
          std::min(earliest_[n], time + norm(subtract(places_[n], place)) / sound_speed[k]);
  }
}

void ReflectionClock::exchange(Archive& archive) {
  archive.array("reflections/earliest", "s", earliest_);
  archive.array("reflections/first_pressure", "Pa", first_);
  archive.array("reflections/seen", "", has_seen_);
}

}  // namespace moraine
