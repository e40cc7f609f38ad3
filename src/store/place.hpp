// Where a particle is, in as many dimensions as a point has.
#pragma once

#include "base/vec3.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// Position [m]; components beyond the dimension are zero.
inline Vec3 place_of(ParticleStore const& store, std::size_t i) {
  Vec3 place{};
  for (int axis = 0; axis < store.dimension(); ++axis)
    place[static_cast<std::size_t>(axis)] = store.component(Field::position, axis)[i];
  return place;
}

}  // namespace moraine
