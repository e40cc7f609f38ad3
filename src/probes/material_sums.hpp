// Sums over the particles of one material.
#pragma once

#include <cstdint>

#include "base/vec3.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// In 2D per metre of thickness, in 1D per square metre.
struct MaterialSums {
  std::uint64_t particles = 0;
  double mass = 0.0;              // kg
  double kinetic_energy = 0.0;    // J
  double internal_energy = 0.0;   // J
  double potential_energy = 0.0;  // J, - m g . x
  Vec3 momentum{};                // kg m/s
};

/// Sums of the fluid particles of a material; gravity in m/s^2. The same bits for any number of
/// threads.
MaterialSums sum_material(ParticleStore const& store, MaterialId material, Vec3 const& gravity);

}  // namespace moraine
