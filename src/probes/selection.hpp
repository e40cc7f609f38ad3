// Which particles a probe looks at.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec3.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// A box of places [m], both corners included.
struct PlaceBox {
  Vec3 min{}, max{};
  bool holds(Vec3 const& x, int dimension) const {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
      if (x[axis] < min[axis] || x[axis] > max[axis]) return false;
    return true;
  }
};

/// Fluid particles of these materials (none: of all) inside this box (none: anywhere).
struct Selection {
  std::vector<MaterialId> materials;
  std::optional<PlaceBox> within;

  bool has(ParticleStore const& store, std::size_t i) const;

  /// For each fluid particle 1 or 0.
  std::vector<std::uint8_t> of(ParticleStore const& store) const;
};

/// Place of a particle; zero beyond the dimension.
inline Vec3 particle_place(ParticleStore const& store, std::size_t i) {
  Vec3 x{};
  for (int axis = 0; axis < store.dimension(); ++axis)
    x[static_cast<std::size_t>(axis)] = store.component(Field::position, axis)[i];
  return x;
}

/// Edge of the cube (square, piece) with the volume of a particle [m].
double size_of_particle(ParticleStore const& store, std::size_t i);

/// The direction that heights are counted in.
struct Upwards {
  std::size_t axis = 1;
  double sign = 1.0;
  double height(Vec3 const& x) const { return sign * x[axis]; }
  /// The place above or below x at this height.
  Vec3 at(Vec3 x, double height) const {
    x[axis] = sign * height;
    return x;
  }
};

}  // namespace moraine
