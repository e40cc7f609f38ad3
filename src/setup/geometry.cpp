#include "setup/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setup/check_motion.hpp"
#include "setup/mirror_walls.hpp"

namespace moraine {
double length(Point const& vector) { return std::hypot(vector[0], vector[1], vector[2]); }

bool is_inside(Box const& inner, Box const& outer, int dimension) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    double const size = outer.max[axis] - outer.min[axis];
    double const tolerance = std::isfinite(size) ? 1e-9 * size : 0.0;
    if (inner.min[axis] < outer.min[axis] - tolerance) return false;
    if (inner.max[axis] > outer.max[axis] + tolerance) return false;
  }
  return true;
}

Box common(Box a, Box const& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    a.min[axis] = std::max(a.min[axis], b.min[axis]);
    a.max[axis] = std::min(a.max[axis], b.max[axis]);
  }
  return a;
}

Box with_mirror_images(Box box, Case const& c) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_plane(c, axis, 0)) box.min[axis] = -infinity;
    if (is_plane(c, axis, 1)) box.max[axis] = infinity;
  }
  return box;
}

std::optional<Box> box_around_regions(Case const& c) {
  std::optional<Box> result;
  for (auto const& region : c.regions) {
    auto const box = bounding_box_of_tree(region, c.dimension);
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
    add(swept_box(wall, c));
    bounded = bounded || wall.form == WallForm::container;
  }
  for (auto const& region : c.regions)
    if (auto const other = bounding_box_of_tree(region, c.dimension)) {
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
