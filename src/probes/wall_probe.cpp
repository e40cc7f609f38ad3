#include "probes/wall_probe.hpp"

#include <algorithm>
#include <cmath>

#include "probes/face_probe.hpp"

namespace moraine {
namespace {

/// Adds the pressure at the face in front of a wall particle of the first row.
void add_pressure(WallSurroundings const& at, WallPoint const& point, std::size_t k,
                  Vec3 const& place, WallReading& reading) {
  Vec3 const normal = at.walls.normal(point);
  Vec3 const gravity = subtract(at.gravity, at.walls.acceleration(point, place));
  bool const first_row = dot(normal, normal) > 0.5 && point.depth < at.spacing;
  if (!first_row) return;
  double const pressure = at.store.scalar(Field::pressure)[k] +
                          at.store.scalar(Field::density)[k] * point.depth * dot(gravity, normal);
  double const area = std::pow(at.spacing, at.store.dimension() - 1);
  reading.largest_pressure =
      reading.wet_area > 0.0 ? std::max(reading.largest_pressure, pressure) : pressure;
  reading.mean_pressure += pressure * area;
  reading.wet_area += area;
}

}  // namespace

WallReading probe_wall(WallSurroundings const& at, WallPart const& part) {
  WallReading reading;
  auto const& wet = at.search.wet_walls();
  std::size_t const first = at.store.range(Kind::wall).begin;
  for (std::size_t n = 0; n < wet.size(); ++n) {
    std::size_t const k = first + wet[n];
    std::size_t const point = at.store.id()[k] - at.walls.first_id;
    if (!at.loads[n].wet || part.member[point] == 0) continue;
    Vec3 place{};
    for (int axis = 0; axis < at.store.dimension(); ++axis)
      place[static_cast<std::size_t>(axis)] = at.store.component(Field::position, axis)[k];
    at.symmetry.for_each_image(
        at.low, at.high, place, at.loads[n].force, [&](Vec3 const& where, Vec3 const& force) {
          reading.force = add(reading.force, force);
          reading.torque = add(reading.torque, cross(subtract(where, part.about), force));
        });
    add_pressure(at, at.walls.points[point], k, place, reading);
  }
  add_face_loads(at, part, reading);
  if (reading.wet_area > 0.0) reading.mean_pressure /= reading.wet_area;
  reading.wet_area = at.symmetry.whole(reading.wet_area);
  return reading;
}

}  // namespace moraine
