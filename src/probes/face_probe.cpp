#include "probes/face_probe.hpp"

#include <algorithm>
#include <cmath>

#include "probes/kernel_shape.hpp"
#include "walls/face_push.hpp"

namespace moraine {
namespace {

Vec3 particle_place(ParticleStore const& store, std::size_t i) {
  Vec3 place{};
  for (int axis = 0; axis < store.dimension(); ++axis)
    place[static_cast<std::size_t>(axis)] = store.component(Field::position, axis)[i];
  return place;
}

RigidState const* motion_of(WallSurroundings const& at, WallFace const& face) {
  return face.body == WallFace::at_rest ? nullptr : &at.walls.bodies[face.body].state;
}

/// Whether the foot of a particle on a face lies in the part of it that is measured.
bool is_on(FacePart const& part, WallFace const& face, RigidState const* motion, Vec3 place,
           int dimension) {
  if (motion != nullptr) place = motion->start_of(place);
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    // Beyond an edge of the face the foot is on the edge.
    double const foot = std::clamp(place[k], face.low[k], face.high[k]);
    if (foot < part.low[k] || foot > part.high[k]) return false;
  }
  return true;
}

void add_force(WallSurroundings const& at, WallPart const& part, Vec3 const& place,
               Vec3 const& force, WallReading& reading) {
  at.symmetry.for_each_image(at.low, at.high, place, force, [&](Vec3 const& x, Vec3 const& f) {
    reading.force = add(reading.force, f);
    reading.torque = add(reading.torque, cross(subtract(x, part.about), f));
  });
}

void add_mirror_forces(WallSurroundings const& at, WallPart const& part, FacePart const& face_part,
                       WallReading& reading) {
  WallFace const& face = at.walls.faces[face_part.face];
  if (!face.mirror) return;
  for (MirrorLoad const& load : at.mirror_loads) {
    Vec3 const place = particle_place(at.store, load.particle);
    if (is_on(face_part, face, nullptr, place, at.store.dimension()))
      add_force(at, part, place, load.force[2 * face.axis + face.end], reading);
  }
}

void add_push_forces(WallSurroundings const& at, WallPart const& part, FacePart const& face_part,
                     WallReading& reading) {
  WallFace const& face = at.walls.faces[face_part.face];
  if (!(face.repulsion.strength > 0.0)) return;
  auto const mass = at.store.scalar(Field::mass);
  for (std::size_t i = 0; i < at.store.range(Kind::fluid).size(); ++i) {
    Vec3 const place = particle_place(at.store, i);
    PushOnParticle const push = push_of(at.walls, face, at.store.dimension(), place);
    if (push.stiffness != 0.0 &&
        is_on(face_part, face, motion_of(at, face), place, at.store.dimension()))
      add_force(at, part, place, scale(-mass[i], push.acceleration), reading);
  }
}

struct SpotState {
  double weight = 0.0;
  double pressure = 0.0;  // sums with the weights
};

SpotState look_from(WallSurroundings const& at, Vec3 const& spot, Vec3 const& gravity) {
  SpotState sums;
  bool const varies = at.store.has(Field::smoothing_length);
  double const reach = std::max(kernel_support * at.smoothing_length, at.search.largest_support());
  auto const include = [&](std::size_t i, Search::Viewpoint const& from) {
    if (from.sign != Vec3{1.0, 1.0, 1.0}) return;  // images show nothing that is not linear
    Vec3 const apart = subtract(from.place, particle_place(at.store, i));
    double const h =
        varies ? std::max(at.store.scalar(Field::smoothing_length)[i], at.smoothing_length)
               : at.smoothing_length;
    double const q = norm(apart) / h;
    if (q >= kernel_support) return;
    double const w = std::max(kernel_shape(at.kernel, at.store.dimension(), q), 0.0) *
                     std::pow(at.smoothing_length / h, at.store.dimension());
    sums.weight += w;
    sums.pressure += w * (at.store.scalar(Field::pressure)[i] +
                          at.store.scalar(Field::density)[i] * dot(gravity, apart));
  };
  at.search.for_each_fluid_near(spot, reach, include);
  return sums;
}

void add_pressures(WallSurroundings const& at, FacePart const& part, WallReading& reading) {
  RigidState const* const motion = motion_of(at, at.walls.faces[part.face]);
  for (FaceSpot const& spot : part.spots) {
    Vec3 const place = motion != nullptr ? motion->place(spot.place) : spot.place;
    Vec3 const gravity =
        motion != nullptr ? subtract(at.gravity, motion->acceleration(place)) : at.gravity;
    SpotState const seen = look_from(at, place, gravity);
    if (!(seen.weight > 0.0)) continue;
    double const pressure = seen.pressure / seen.weight;
    reading.largest_pressure =
        reading.wet_area > 0.0 ? std::max(reading.largest_pressure, pressure) : pressure;
    reading.mean_pressure += pressure * spot.area;
    reading.wet_area += spot.area;
  }
}

}  // namespace

void add_face_loads(WallSurroundings const& at, WallPart const& part, WallReading& reading) {
  for (FacePart const& face : part.faces) {
    add_mirror_forces(at, part, face, reading);
    add_push_forces(at, part, face, reading);
    add_pressures(at, face, reading);
  }
}

}  // namespace moraine
