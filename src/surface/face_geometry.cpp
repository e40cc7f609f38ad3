#include "surface/face_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moraine {
namespace {

// Left of the direction (2D).
Vec3 turn_left(Vec3 const& a) { return {-a[1], a[0], 0.0}; }

Vec3 at(Corners const& corners, FaceCoordinates const& uv) {
  auto const share = shape_functions(uv);
  return add(scale(share[0], corners[0]),
             add(scale(share[1], corners[1]), scale(share[2], corners[2])));
}

// Part of the way from a to b at which the segment is nearest to the point, from 0 to 1.
double nearest_part(Vec3 const& a, Vec3 const& b, Vec3 const& point) {
  Vec3 const along = subtract(b, a);
  return std::clamp(dot(subtract(point, a), along) / dot(along, along), 0.0, 1.0);
}

double corner_angle(Vec3 const& corner, Vec3 const& next, Vec3 const& last) {
  Vec3 const a = subtract(next, corner);
  Vec3 const b = subtract(last, corner);
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

NearestOnFace nearest_on_edges(Corners const& x, Vec3 const& point) {
  NearestOnFace best{};
  double least = INFINITY;
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t const next = (k + 1) % 3;
    double const part = nearest_part(x[k], x[next], point);
    std::array<double, 3> share{};
    share[k] = 1.0 - part;
    share[next] = part;
    FaceCoordinates const uv{share[1], share[2]};
    Vec3 const position = at(x, uv);
    Vec3 const away = subtract(point, position);
    if (dot(away, away) >= least) continue;
    least = dot(away, away);
    double angle = std::numbers::pi;
    if (part == 0.0) angle = corner_angle(x[k], x[next], x[(k + 2) % 3]);
    if (part == 1.0) angle = corner_angle(x[next], x[(k + 2) % 3], x[k]);
    best = {position, uv, angle};
  }
  return best;
}

NearestOnFace nearest_on_triangle(Corners const& x, Vec3 const& point) {
  Vec3 const normal = area_normal(3, x);
  Vec3 const from_first = subtract(point, x[0]);
  double const inv_square = 1.0 / dot(normal, normal);
  FaceCoordinates const uv{dot(cross(from_first, subtract(x[2], x[0])), normal) * inv_square,
                           dot(cross(subtract(x[1], x[0]), from_first), normal) * inv_square};
  bool const inside = uv[0] > 0.0 && uv[1] > 0.0 && uv[0] + uv[1] < 1.0;
  if (inside) return {at(x, uv), uv, 2.0 * std::numbers::pi};
  return nearest_on_edges(x, point);
}

}  // namespace

Vec3 area_normal(int dimension, Corners const& corners) {
  if (dimension == 1) return {1.0, 0.0, 0.0};
  Vec3 const first = subtract(corners[1], corners[0]);
  if (dimension == 2) return turn_left(first);
  return cross(first, subtract(corners[2], corners[0]));
}

Vec3 area_normal_rate(int dimension, Corners const& corners, Corners const& velocities) {
  if (dimension == 1) return {};
  Vec3 const first_rate = subtract(velocities[1], velocities[0]);
  if (dimension == 2) return turn_left(first_rate);
  return add(cross(first_rate, subtract(corners[2], corners[0])),
             cross(subtract(corners[1], corners[0]), subtract(velocities[2], velocities[0])));
}

NearestOnFace nearest_on_face(int dimension, Corners const& corners, Vec3 const& point) {
  if (dimension == 1) return {corners[0], {}, 1.0};
  if (dimension == 3) return nearest_on_triangle(corners, point);
  FaceCoordinates const uv{nearest_part(corners[0], corners[1], point), 0.0};
  return {at(corners, uv), uv, 1.0};
}

}  // namespace moraine
