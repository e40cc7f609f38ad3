#include "setup/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace moraine {
namespace {

Point minus(Point const& a, Point const& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double dot(Point const& a, Point const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Box around(Box const& a, Box const& b) {
  Box result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.min[axis] = std::min(a.min[axis], b.min[axis]);
    result.max[axis] = std::max(a.max[axis], b.max[axis]);
  }
  return result;
}

struct Contains {
  Point const& point;
  int dimension;
  double tolerance;

  bool operator()(Box const& box) const { return contains(box, point, dimension, tolerance); }
  bool operator()(Disc const& disc) const {
    return length(minus(point, disc.center)) <= disc.radius + tolerance;
  }
  bool operator()(HalfPlane const& plane) const {
    return dot(minus(point, plane.point), plane.normal) <= tolerance;
  }
};

}  // namespace

double length(Point const& vector) { return std::hypot(vector[0], vector[1], vector[2]); }

bool contains(Box const& box, Point const& point, int dimension, double tolerance) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    if (point[axis] < box.min[axis] - tolerance || point[axis] >= box.max[axis] - tolerance)
      return false;
  return true;
}

bool contains(Shape const& shape, Point const& point, int dimension, double tolerance) {
  return std::visit(Contains{point, dimension, tolerance}, shape);
}

bool is_inside(Box const& inner, Box const& outer, int dimension) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    double const tolerance = 1e-9 * (outer.max[axis] - outer.min[axis]);
    if (inner.min[axis] < outer.min[axis] - tolerance) return false;
    if (inner.max[axis] > outer.max[axis] + tolerance) return false;
  }
  return true;
}

std::optional<Box> bounding_box(Shape const& shape, int dimension) {
  if (auto const* box = std::get_if<Box>(&shape)) return *box;
  auto const* disc = std::get_if<Disc>(&shape);
  if (disc == nullptr) return std::nullopt;
  Box box{disc->center, disc->center};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    box.min[axis] -= disc->radius;
    box.max[axis] += disc->radius;
  }
  return box;
}

std::optional<Box> box_around_regions(Case const& c) {
  std::optional<Box> result;
  for (auto const& region : c.regions) {
    auto const box = bounding_box(region.shape, c.dimension);
    if (!box) return std::nullopt;
    result = result ? around(*result, *box) : *box;
  }
  return result;
}

std::optional<Box> default_domain(Case const& c) {
  std::optional<Box> box;
  bool bounded = false;
  auto const add = [&](Box const& other) { box = box ? around(*box, other) : other; };
  for (auto const& wall : c.walls) {
    add(wall.box);
    bounded = bounded || wall.form == WallForm::container;
  }
  for (auto const& region : c.regions)
    if (auto const other = bounding_box(region.shape, c.dimension)) {
      add(*other);
      bounded = true;
    }
  if (!bounded) return std::nullopt;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (c.periodic[axis]) continue;
    double const extent = box->max[axis] - box->min[axis];
    box->min[axis] -= extent;
    box->max[axis] += extent;
  }
  return box;
}

}  // namespace moraine
