#include "surface/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace moraine {
namespace {

Vec3 interpolate(Corners const& values, FaceCoordinates const& uv, int dimension) {
  auto const share = shape_functions(uv);
  Vec3 sum{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    sum = add(sum, scale(share[k], values[k]));
  return sum;
}

}  // namespace

Surface::Surface(int dimension, std::uint32_t owner, std::vector<Vec3> vertices,
                 std::vector<Face> faces)
    : dimension_(dimension),
      owner_(owner),
      faces_(std::move(faces)),
      position_(std::move(vertices)),
      velocity_(position_.size()),
      acceleration_(position_.size()),
      force_(position_.size()) {
  check();
}

void Surface::check() const {
  if (dimension_ < 1 || dimension_ > 3)
    throw std::invalid_argument("surface: the dimension must be 1, 2 or 3");
  if (faces_.empty()) throw std::invalid_argument("surface: there are no faces");
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    std::string const which = "surface: face " + std::to_string(f);
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k)
      if (faces_[f].vertex[k] >= position_.size())
        throw std::invalid_argument(which + " has a corner that does not exist");
    if (faces_[f].side != 1 && faces_[f].side != -1)
      throw std::invalid_argument(which + " must have side +1 or -1");
    if (!(area(f) > 0.0)) throw std::invalid_argument(which + " has no extent");
  }
}

Corners Surface::corners(std::vector<Vec3> const& values, std::size_t face) const {
  Corners result{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k)
    result[k] = values[faces_[face].vertex[k]];
  return result;
}

Vec3 Surface::normal(std::size_t face) const {
  Vec3 const raw = area_normal(dimension_, corners(position_, face));
  return scale(faces_[face].side / norm(raw), raw);
}

double Surface::area(std::size_t face) const {
  double const length = norm(area_normal(dimension_, corners(position_, face)));
  return dimension_ == 3 ? 0.5 * length : length;
}

SurfaceSample Surface::sample(std::size_t face, FaceCoordinates const& uv, double depth) const {
  Corners const x = corners(position_, face);
  Corners const v = corners(velocity_, face);
  Vec3 const raw = area_normal(dimension_, x);
  double const factor = faces_[face].side / norm(raw);
  Vec3 const n = scale(factor, raw);
  // d/dt (raw / |raw|): the part of the rate that is normal to n.
  Vec3 const rate = scale(factor, area_normal_rate(dimension_, x, v));
  Vec3 const n_rate = subtract(rate, scale(dot(rate, n), n));
  return {subtract(interpolate(x, uv, dimension_), scale(depth, n)),
          subtract(interpolate(v, uv, dimension_), scale(depth, n_rate)),
          interpolate(corners(acceleration_, face), uv, dimension_), n};
}

void Surface::add_force(std::size_t face, FaceCoordinates const& uv, Vec3 const& force) {
  auto const share = shape_functions(uv);
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
    Vec3& sum = force_[faces_[face].vertex[k]];
    sum = add(sum, scale(share[k], force));
  }
}

void Surface::clear_forces() { std::fill(force_.begin(), force_.end(), Vec3{}); }

SurfaceDistance Surface::distance(Vec3 const& point) const {
  SurfaceDistance best;
  double least = std::numeric_limits<double>::infinity();
  double size = 0.0;  // of the coordinates, for the tolerance below
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    NearestOnFace const nearest = nearest_on_face(dimension_, corners(position_, f), point);
    double const away = norm(subtract(point, nearest.position));
    size = std::max({size, norm(nearest.position), away});
    if (away < least) {
      least = away;
      best = {away, f, nearest.uv, nearest.position};
    }
  }
  // Faces that meet at the nearest place find it with different rounding.
  double const same_place = 1e-12 * size;
  Vec3 pseudo_normal{};
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    NearestOnFace const nearest = nearest_on_face(dimension_, corners(position_, f), point);
    if (norm(subtract(nearest.position, best.position)) <= same_place)
      pseudo_normal = add(pseudo_normal, scale(nearest.angle, normal(f)));
  }
  if (dot(subtract(point, best.position), pseudo_normal) < 0.0) best.distance = -least;
  return best;
}

}  // namespace moraine
