#include "walls/box_wall.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace moraine {
namespace {

constexpr double seam_tolerance = 1e-9;  // of the period

std::size_t axes(BoxWall const& wall) { return static_cast<std::size_t>(wall.dimension); }

double period(BoxWall const& wall, std::size_t axis) {
  return wall.periodic.max[axis] - wall.periodic.min[axis];
}

void check_axis(BoxWall const& wall, std::size_t axis) {
  std::string const which = std::string("box wall: on axis ") + "xyz"[axis];
  if (!(wall.max[axis] > wall.min[axis]))
    throw std::invalid_argument(which + " the upper corner is not above the lower one");
  if (!wall.periodic.periodic[axis]) return;
  if (!(period(wall, axis) > 0.0))
    throw std::invalid_argument(which + " the period is not positive");
  if (spans_period(wall, axis)) return;
  double const slack = seam_tolerance * period(wall, axis);
  bool const within = wall.min[axis] >= wall.periodic.min[axis] - slack &&
                      wall.max[axis] <= wall.periodic.max[axis] + slack;
  if (wall.solid == SolidSide::outside || !within)
    throw std::invalid_argument(which + (wall.solid == SolidSide::outside
                                             ? " a container must span the period"
                                             : " an obstacle must span or lie within the period"));
}

// The other axes of a side: one in 2D, two in 3D in the order that makes (first, second, axis)
// right-handed.
std::size_t first_tangent(BoxWall const& wall, std::size_t axis) {
  return wall.dimension == 2 ? 1 - axis : (axis + 1) % 3;
}
std::size_t second_tangent(std::size_t axis) { return (axis + 2) % 3; }

// Sign along the axis of area_normal for the corners that add_side gives.
int raw_sign(BoxWall const& wall, std::size_t axis) {
  return wall.dimension == 2 && axis == 0 ? -1 : +1;
}

// Vertex number k is the corner at the plus end of the axes whose bits are set in k.
void add_side(BoxWall const& wall, BoxSide const& side, std::vector<Face>& faces) {
  auto const bit = [](std::size_t axis) { return static_cast<std::uint32_t>(1U << axis); };
  std::uint32_t const base = side.end == 1 ? bit(side.axis) : 0U;
  int const sign = side.fluid_sign > 0.0 ? raw_sign(wall, side.axis) : -raw_sign(wall, side.axis);
  if (wall.dimension == 1) {
    faces.push_back({{base}, sign});
    return;
  }
  std::uint32_t const first = base | bit(first_tangent(wall, side.axis));
  if (wall.dimension == 2) {
    faces.push_back({{base, first}, sign});
    return;
  }
  std::uint32_t const second = base | bit(second_tangent(side.axis));
  faces.push_back({{base, first, second}, sign});
  faces.push_back({{first | second, second, first}, sign});
}

}  // namespace

bool spans_period(BoxWall const& wall, std::size_t axis) {
  return wall.periodic.periodic[axis] &&
         wall.max[axis] - wall.min[axis] >= period(wall, axis) * (1.0 - seam_tolerance);
}

void check(BoxWall const& wall) {
  if (wall.dimension < 1 || wall.dimension > 3)
    throw std::invalid_argument("box wall: the dimension must be 1, 2 or 3");
  for (std::size_t axis = 0; axis < axes(wall); ++axis) check_axis(wall, axis);
  if (closed_sides(wall).empty()) throw std::invalid_argument("box wall: no side is closed");
}

std::array<Vec3, 2> covered_box(BoxWall const& wall) {
  std::array<Vec3, 2> box{};
  for (std::size_t axis = 0; axis < axes(wall); ++axis) {
    bool const cut = spans_period(wall, axis);
    box[0][axis] = cut ? wall.periodic.min[axis] : wall.min[axis];
    box[1][axis] = cut ? wall.periodic.max[axis] : wall.max[axis];
  }
  return box;
}

std::vector<BoxSide> closed_sides(BoxWall const& wall) {
  std::vector<BoxSide> sides;
  for (std::size_t axis = 0; axis < axes(wall); ++axis) {
    if (spans_period(wall, axis)) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      bool const fluid_above = (end == 0) == (wall.solid == SolidSide::outside);
      if (!wall.open[axis][end]) sides.push_back({axis, end, fluid_above ? 1.0 : -1.0});
    }
  }
  return sides;
}

Surface make_box_surface(BoxWall const& wall, std::uint32_t owner) {
  check(wall);
  auto const box = covered_box(wall);
  std::vector<Vec3> vertices(std::size_t{1} << axes(wall));
  for (std::size_t k = 0; k < vertices.size(); ++k)
    for (std::size_t axis = 0; axis < axes(wall); ++axis)
      vertices[k][axis] = box[(k >> axis) & 1][axis];
  std::vector<Face> faces;
  for (BoxSide const& side : closed_sides(wall)) add_side(wall, side, faces);
  return Surface(wall.dimension, owner, std::move(vertices), std::move(faces));
}

FacePlace place_on_side(BoxWall const& wall, std::size_t side, Vec3 const& point) {
  auto const face = static_cast<std::uint32_t>(side);
  if (wall.dimension == 1) return {face, {}};
  auto const box = covered_box(wall);
  auto const part = [&](std::size_t axis) {
    return (point[axis] - box[0][axis]) / (box[1][axis] - box[0][axis]);
  };
  std::size_t const axis = closed_sides(wall)[side].axis;
  double const u = part(first_tangent(wall, axis));
  if (wall.dimension == 2) return {face, {u, 0.0}};
  double const v = part(second_tangent(axis));
  if (u + v <= 1.0) return {2 * face, {u, v}};
  return {2 * face + 1, {1.0 - u, 1.0 - v}};
}

}  // namespace moraine
