// A fixed rigid wall made of the sides of a box.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.hpp"
#include "surface/surface.hpp"

namespace moraine {

/// Which side of the box's faces the solid is on: a tank has it outside, an obstacle inside.
enum class SolidSide : std::uint8_t { outside, inside };

/// Axes on which the domain repeats, and one period of each.
struct PeriodicAxes {
  std::array<bool, 3> periodic{};
  Vec3 min{};  // m, read on periodic axes only
  Vec3 max{};  // m
};

/// The closed sides of an axis-aligned box (of an interval in 1D, a rectangle in 2D).
///
/// A box that is at least as long as the period of a periodic axis has no sides there: it is cut to
/// the period, whose ends touch. A shorter obstacle must lie within the period.
struct BoxWall {
  int dimension = 3;
  Vec3 min{};  // m, lower corner; entries beyond the dimension are not read
  Vec3 max{};  // m, upper corner
  SolidSide solid = SolidSide::outside;
  std::array<std::array<bool, 2>, 3> open{};  // [axis][0: minus side, 1: plus side]: no wall there
  PeriodicAxes periodic{};
};

/// A closed side: its plane is perpendicular to `axis`.
struct BoxSide {
  std::size_t axis = 0;
  std::size_t end = 0;      // 0: minus side, 1: plus side
  double fluid_sign = 1.0;  // the normal into the fluid is fluid_sign times the axis
};

/// A place on the faces of make_box_surface.
struct FacePlace {
  std::uint32_t face = 0;
  FaceCoordinates uv{};
};

/// Throws std::invalid_argument, with the axis and the reason, where the wall has no closed side,
/// is empty on an axis, or lies across the seam of a periodic axis that it does not span.
void check(BoxWall const& wall);

/// Whether the box covers the whole period of a periodic axis (to 1e-9 of it).
bool spans_period(BoxWall const& wall, std::size_t axis);

/// The box, cut to the period on the axes that it spans: lower and upper corner.
std::array<Vec3, 2> covered_box(BoxWall const& wall);

/// The closed sides in the order x-, x+, y-, y+, z-, z+.
std::vector<BoxSide> closed_sides(BoxWall const& wall);

/// The sides as a surface at rest: per closed side one face in 1D and 2D, two triangles in 3D.
/// Errors as `check`.
Surface make_box_surface(BoxWall const& wall, std::uint32_t owner);

/// Where the foot of the perpendicular from `point` to the plane of closed side number `side` lies
/// in terms of the faces of make_box_surface; beyond the side's edges its faces are continued.
FacePlace place_on_side(BoxWall const& wall, std::size_t side, Vec3 const& point);

}  // namespace moraine
