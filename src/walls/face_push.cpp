#include "walls/face_push.hpp"

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

FacePush push_from_faces(ParticleStore& store, WallData const& walls) {
  auto const axes = static_cast<std::size_t>(store.dimension());
  auto const mass = store.scalar(Field::mass);
  std::array<std::span<double>, 3> position, acceleration;
  for (std::size_t k = 0; k < axes; ++k) {
    position[k] = store.component(Field::position, static_cast<int>(k));
    acceleration[k] = store.component(Field::acceleration, static_cast<int>(k));
  }
  auto const of_block = [&](std::size_t begin, std::size_t end) {
    FacePush sum;
    for (WallFace const& face : walls.faces) {
      if (!(face.repulsion.strength > 0.0)) continue;
      bool const at_rest = face.body == WallFace::at_rest;
      for (std::size_t i = begin; i < end; ++i) {
        double const gap = position[face.axis][i] - face.low[face.axis];
        if (at_rest && std::fabs(gap) >= face.repulsion.range) continue;  // most of them
        Vec3 place{};
        for (std::size_t k = 0; k < axes; ++k) place[k] = position[k][i];
        PushOnParticle const push = push_of(walls, face, store.dimension(), place);
        if (push.stiffness == 0.0) continue;
        for (std::size_t k = 0; k < axes; ++k) acceleration[k][i] += push.acceleration[k];
        sum.include({scale(mass[i], push.acceleration), mass[i] * push.power,
                     mass[i] * push.potential, push.stiffness, i});
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
