#include "setup/mirror_walls.hpp"

namespace moraine {
namespace {

/// Whether a side of a wall's box has a mirror.
bool has_mirror(Case const& c, WallSpec const& wall, std::size_t axis, std::size_t end) {
  if (!wall.mirrors() || wall.form != WallForm::container || wall.open[axis][end]) return false;
  if (axis >= static_cast<std::size_t>(c.dimension) || c.periodic[axis]) return false;
  if (!c.symmetry.planes[axis][end]) return true;
  // A symmetry plane cuts the box.
  return end == 0 ? wall.box.min[axis] > c.domain.min[axis]
                  : wall.box.max[axis] < c.domain.max[axis];
}

}  // namespace

MirrorSides mirror_sides(Case const& c) {
  MirrorSides sides;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t end = 0; end < 2; ++end)
      for (std::size_t w = c.walls.size(); w-- > 0;)
        if (has_mirror(c, c.walls[w], axis, end)) sides[axis][end] = w;
  return sides;
}

bool is_plane(Case const& c, std::size_t axis, std::size_t end) {
  return c.symmetry.planes[axis][end] || mirror_sides(c)[axis][end].has_value();
}

std::array<std::array<Plane, 2>, 3> mirror_planes(Case const& c) {
  auto const sides = mirror_sides(c);
  std::array<std::array<Plane, 2>, 3> planes{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t end = 0; end < 2; ++end)
      if (auto const wall = sides[axis][end])
        planes[axis][end] =
            c.walls[*wall].slip == Slip::free ? Plane::slip_wall : Plane::stick_wall;
  return planes;
}

void end_domain_at_mirrors(Case& c) {
  auto const sides = mirror_sides(c);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (auto const wall = sides[axis][0]) c.domain.min[axis] = c.walls[*wall].box.min[axis];
    if (auto const wall = sides[axis][1]) c.domain.max[axis] = c.walls[*wall].box.max[axis];
  }
}

}  // namespace moraine
