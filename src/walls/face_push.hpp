// What repulsive walls do to the fluid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.hpp"
#include "store/particle_store.hpp"
#include "walls/wall_data.hpp"

namespace moraine {

/// Sums over all fluid particles near repulsive faces.
struct FacePush {
  Vec3 force{};              // N, on the fluid
  double power = 0.0;        // W, of the force at the velocity of the walls
  double energy = 0.0;       // J, potential of the repulsion
  double stiffness = 0.0;    // 1/s^2, the largest of a particle, over its mass
  std::size_t particle = 0;  // whose

  void include(FacePush const& other);
};

/// The push of one face on a particle, per mass.
struct PushOnParticle {
  Vec3 acceleration{};     // m/s^2
  double power = 0.0;      // W/kg, at the velocity of the face
  double potential = 0.0;  // J/kg
  double stiffness = 0.0;  // 1/s^2, summed over wall particles: no less than that of any direction
};
PushOnParticle push_of(WallData const& walls, WallFace const& face, int dimension,
                       Vec3 const& place);

/// Adds the repulsion of all faces to the accelerations of the fluid. A particle that may come
/// within the range in the next `ahead` seconds counts with the stiffness there already: otherwise
/// a step would be chosen that carries it through the kink where the force begins. Loops in blocks,
/// in double: the same bits for any number of threads.
FacePush push_from_faces(ParticleStore& store, WallData const& walls, double ahead);

}  // namespace moraine
