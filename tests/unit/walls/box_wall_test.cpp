#include "walls/box_wall.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

namespace moraine {
namespace {

BoxWall unit_box(int dimension, SolidSide solid) {
  return {.dimension = dimension, .min = {0, 0, 0}, .max = {1, 1, 1}, .solid = solid};
}

class BoxSurface : public testing::TestWithParam<int> {};

// The side of the solid, seen by points around the box.
TEST_P(BoxSurface, NormalsPointIntoTheFluid) {
  int const dimension = GetParam();
  auto const point = [dimension](double x) {
    Vec3 p{x, 0.3, 0.6};
    for (std::size_t axis = static_cast<std::size_t>(dimension); axis < 3; ++axis) p[axis] = 0.0;
    return p;
  };
  Surface const tank = make_box_surface(unit_box(dimension, SolidSide::outside), 3);
  EXPECT_EQ(tank.owner(), 3U);
  EXPECT_FALSE(tank.inside_solid(point(0.2)));
  EXPECT_TRUE(tank.inside_solid(point(-0.2)));
  EXPECT_TRUE(tank.inside_solid(point(1.2)));
  Surface const block = make_box_surface(unit_box(dimension, SolidSide::inside), 0);
  EXPECT_TRUE(block.inside_solid(point(0.2)));
  EXPECT_FALSE(block.inside_solid(point(-0.2)));
  EXPECT_FALSE(block.inside_solid(point(1.2)));
}

TEST_P(BoxSurface, HasAllClosedSides) {
  int const dimension = GetParam();
  BoxWall wall = unit_box(dimension, SolidSide::outside);
  std::size_t const faces_per_side = dimension == 3 ? 2 : 1;
  auto const sides = static_cast<std::size_t>(2 * dimension);
  EXPECT_EQ(make_box_surface(wall, 0).faces().size(), sides * faces_per_side);
  wall.open[0][1] = true;
  Surface const open = make_box_surface(wall, 0);
  EXPECT_EQ(open.faces().size(), (sides - 1) * faces_per_side);
  double area = 0.0;
  for (std::size_t f = 0; f < open.faces().size(); ++f) area += open.area(f);
  EXPECT_DOUBLE_EQ(area, static_cast<double>(sides - 1));
}

// For places on and beyond every side: the face found gives the foot of the perpendicular back.
TEST_P(BoxSurface, PlaceOnSideIsTheFootOfThePerpendicular) {
  int const dimension = GetParam();
  BoxWall const wall{.dimension = dimension, .min = {-1, 2, 0.5}, .max = {3, 2.5, 4}};
  Surface const surface = make_box_surface(wall, 0);
  auto const sides = closed_sides(wall);
  for (Vec3 point : {Vec3{0, 2.1, 0.6}, Vec3{2.9, 2.4, 3.9}, Vec3{-2, 3, 5}}) {
    for (std::size_t k = static_cast<std::size_t>(dimension); k < 3; ++k) point[k] = 0.0;
    for (std::size_t s = 0; s < sides.size(); ++s) {
      FacePlace const place = place_on_side(wall, s, point);
      SurfaceSample const foot = surface.sample(place.face, place.uv, 0.0);
      Vec3 expected = point;
      expected[sides[s].axis] = (sides[s].end == 0 ? wall.min : wall.max)[sides[s].axis];
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(foot.position[k], expected[k], 1e-14);
      EXPECT_EQ(foot.normal[sides[s].axis], sides[s].fluid_sign);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, BoxSurface, testing::Values(1, 2, 3));

TEST(BoxWall, SpanningAPeriodLeavesNoSidesThere) {
  BoxWall wall = unit_box(2, SolidSide::inside);
  wall.min[0] = -0.5;
  wall.max[0] = 2.5;
  wall.periodic = {{true, false, false}, {0, 0, 0}, {2, 0, 0}};
  EXPECT_TRUE(spans_period(wall, 0));
  EXPECT_FALSE(spans_period(wall, 1));
  Surface const slab = make_box_surface(wall, 0);
  ASSERT_EQ(slab.faces().size(), 2U);
  EXPECT_DOUBLE_EQ(slab.area(0), 2.0);  // cut to the period
}

std::string message_of(std::function<void(BoxWall&)> const& change) {
  BoxWall wall = unit_box(2, SolidSide::outside);
  change(wall);
  try {
    check(wall);
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

TEST(BoxWall, RefusesWhatIsNoWall) {
  EXPECT_EQ(message_of([](BoxWall&) {}), "");
  EXPECT_EQ(message_of([](BoxWall& w) { w.dimension = 0; }),
            "box wall: the dimension must be 1, 2 or 3");
  EXPECT_EQ(message_of([](BoxWall& w) { w.max[1] = 0.0; }),
            "box wall: on axis y the upper corner is not above the lower one");
  EXPECT_EQ(message_of([](BoxWall& w) {
              w.open = {{{true, true}, {true, true}, {}}};
            }),
            "box wall: no side is closed");
  EXPECT_EQ(message_of([](BoxWall& w) {
              w.periodic = {{true, false, false}, {}, {}};
            }),
            "box wall: on axis x the period is not positive");
  EXPECT_EQ(message_of([](BoxWall& w) {
              w.periodic = {{true, false, false}, {}, {2, 0, 0}};
            }),
            "box wall: on axis x a container must span the period");
  EXPECT_EQ(message_of([](BoxWall& w) {
              w.solid = SolidSide::inside;
              w.periodic = {{true, false, false}, {0.5, 0, 0}, {3, 0, 0}};
            }),
            "box wall: on axis x an obstacle must span or lie within the period");
}

}  // namespace
}  // namespace moraine
