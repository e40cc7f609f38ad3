#include "walls/face_push.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel_for.hpp"
#include "terms/repulsion.hpp"

namespace moraine {

void FacePush::include(FacePush const& other) {
  force = add(force, other.force);
  power += other.power;
  energy += other.energy;
  if (std::isnan(stiffness) || other.stiffness <= stiffness) return;
  stiffness = other.stiffness;
  particle = other.particle;
}

PushOnParticle push_of(WallData const& walls, WallFace const& face, int dimension,
                       Vec3 const& place) {
  RigidState const* const state =
      face.body == WallFace::at_rest ? nullptr : &walls.bodies[face.body].state;
  Vec3 const seen = state != nullptr ? state->start_of(place) : place;
  PushOnParticle push;
  for_each_repulsive_near(face, dimension, seen, [&](Vec3 const& x) {
    Vec3 const from = subtract(seen, x);
    Repulsion const one = repulsion(face.repulsion.strength, face.repulsion.range, dot(from, from));
    Vec3 a = scale(one.over_distance, from);
    if (state != nullptr) {
      a = state->turned(a);
      push.power += dot(a, state->velocity(state->place(x)));
    }
    push.acceleration = add(push.acceleration, a);
    push.potential += one.potential;
    push.stiffness += one.stiffness;
  });
  return push;
}

namespace {

/// Whether a particle is in front of or behind a face and can come within its range soon.
bool is_near(WallData const& walls, WallFace const& face, int dimension, Vec3 place, Vec3 velocity,
             double ahead) {
  if (face.body != WallFace::at_rest) {
    RigidState const& state = walls.bodies[face.body].state;
    velocity = subtract(velocity, state.velocity(place));
    place = state.start_of(place);
  }
  double const reach = face.repulsion.range + ahead * norm(velocity);
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    if (place[k] <= face.low[k] - reach || place[k] >= face.high[k] + reach) return false;
  return true;
}

}  // namespace

FacePush push_from_faces(ParticleStore& store, WallData const& walls, double ahead) {
  int const dimension = store.dimension();
  auto const axes = static_cast<std::size_t>(dimension);
  auto const mass = store.scalar(Field::mass);
  std::array<std::span<double>, 3> position, velocity, acceleration;
  for (std::size_t k = 0; k < axes; ++k) {
    position[k] = store.component(Field::position, static_cast<int>(k));
    velocity[k] = store.component(Field::velocity, static_cast<int>(k));
    acceleration[k] = store.component(Field::acceleration, static_cast<int>(k));
  }
  auto const of_block = [&](std::size_t begin, std::size_t end) {
    FacePush sum;
    for (std::size_t i = begin; i < end; ++i) {
      Vec3 place{}, speed{};
      for (std::size_t k = 0; k < axes; ++k) {
        place[k] = position[k][i];
        speed[k] = velocity[k][i];
      }
      for (WallFace const& face : walls.faces) {
        auto const& [strength, range] = face.repulsion;
        if (!(strength > 0.0) || !is_near(walls, face, dimension, place, speed, ahead)) continue;
        PushOnParticle const push = push_of(walls, face, dimension, place);
        for (std::size_t k = 0; k < axes; ++k) acceleration[k][i] += push.acceleration[k];
        sum.include({scale(mass[i], push.acceleration), mass[i] * push.power,
                     mass[i] * push.potential,
                     std::max(push.stiffness, stiffness_at_range(strength, range)), i});
      }
    }
    return sum;
  };
  return reduce_blocks(store.range(Kind::fluid).size(), FacePush{}, of_block,
                       [](FacePush a, FacePush const& b) {
                         a.include(b);
                         return a;
                       });
}

}  // namespace moraine
