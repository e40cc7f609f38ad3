#include "walls/dummy_layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>

namespace moraine {
namespace {

constexpr double dp = 0.1;

struct Layout {
  std::string name;
  BoxWall wall;
  std::size_t count;  // with spacing dp and three layers, by hand
};

void PrintTo(Layout const& layout, std::ostream* out) { *out << layout.name; }

BoxWall box(int dimension, Vec3 const& max, SolidSide solid) {
  return {.dimension = dimension, .min = {0, 0, 0}, .max = max, .solid = solid};
}

BoxWall with_open_top(BoxWall wall) {
  wall.open[static_cast<std::size_t>(wall.dimension - 1)][1] = true;
  return wall;
}

BoxWall periodic_in_x(BoxWall wall, double period) {
  wall.periodic = {{true, false, false}, {0, 0, 0}, {period, 0, 0}};
  return wall;
}

std::vector<Layout> layouts() {
  using enum SolidSide;
  return {
      {"tank_1d", box(1, {1, 0, 0}, outside), 6},
      {"tank_2d", box(2, {1, 0.5, 0}, outside), 16 * 11 - 10 * 5},
      {"tank_3d", box(3, {0.4, 0.5, 0.6}, outside), 10 * 11 * 12 - 4 * 5 * 6},
      {"open_tank_2d", with_open_top(box(2, {1, 0.5, 0}, outside)), 16 * 8 - 10 * 5},
      {"open_tank_3d", with_open_top(box(3, {0.4, 0.5, 0.6}, outside)), 10 * 11 * 9 - 4 * 5 * 6},
      {"uneven_tank_2d", box(2, {1.03, 0.47, 0}, outside), 16 * 11 - 10 * 5},
      {"half_spacing_tank_2d", box(2, {0.25, 0.45, 0}, outside), 8 * 10 - 2 * 4},
      {"channel_2d", periodic_in_x(box(2, {1, 0.5, 0}, outside), 1), 10 * 6},
      {"uneven_channel_3d", periodic_in_x(box(3, {0.97, 0.5, 0.4}, outside), 0.97),
       10 * (11 * 10 - 5 * 4)},
      {"block_1d", box(1, {1, 0, 0}, inside), 6},
      {"block_2d", box(2, {1, 0.8, 0}, inside), 10 * 8 - 4 * 2},
      {"block_3d", box(3, {1, 0.8, 0.7}, inside), 10 * 8 * 7 - 4 * 2 * 1},
      {"uneven_block_2d", box(2, {1.04, 0.83, 0}, inside), 10 * 8 - 4 * 2},
      {"thin_block_2d", box(2, {1, 0.2, 0}, inside), 10 * 2},
      {"thinnest_block_2d", box(2, {1, 0.1, 0}, inside), 10},
      {"open_block_2d", with_open_top(box(2, {1, 0.8, 0}, inside)), 10 * 8 - 4 * 5},
      {"periodic_floor_2d", periodic_in_x(box(2, {1, 0.8, 0}, inside), 1), 10 * 6},
      {"block_in_period_2d", periodic_in_x(box(2, {1, 0.8, 0}, inside), 2), 10 * 8 - 4 * 2},
  };
}

class DummyLayer : public testing::TestWithParam<Layout> {
 protected:
  std::vector<Dummy> dummies() const { return make_dummy_layer(GetParam().wall, dp, 3, 9); }
};

TEST_P(DummyLayer, CountAndSurface) {
  auto const all = dummies();
  EXPECT_EQ(all.size(), GetParam().count);
  for (Dummy const& dummy : all) EXPECT_EQ(dummy.surface, 9U);
}

// Every dummy is where its face, place and depth say, on the solid's side, and the layers have the
// stated depths. 1e-13: rounding of coordinates of order one.
TEST_P(DummyLayer, LiesBehindTheSurface) {
  Surface const surface = make_box_surface(GetParam().wall, 9);
  double least = INFINITY;
  for (Dummy const& dummy : dummies()) {
    Vec3 const again = surface.sample(dummy.face, dummy.uv, dummy.depth).position;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(again[k], dummy.position[k], 1e-13);
    double const distance = surface.distance(dummy.position).distance;
    EXPECT_LE(distance, -0.5 * dp + 1e-13);
    EXPECT_LE(dummy.depth, -distance + 1e-13);
    EXPECT_LT(dummy.depth, 3 * dp);
    least = std::min(least, dummy.depth);
  }
  EXPECT_NEAR(least, 0.5 * dp, 1e-13);
}

// No two dummies, nor their periodic images, are closer than half a spacing, the least distance at
// the inner corner of an uneven tank; elsewhere 0.9 spacings for the lengths above.
TEST_P(DummyLayer, HasNoDuplicates) {
  auto const all = dummies();
  PeriodicAxes const& periodic = GetParam().wall.periodic;
  double least = INFINITY;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 apart = subtract(all[i].position, all[j].position);
      for (std::size_t k = 0; k < 3; ++k) {
        double const period = periodic.max[k] - periodic.min[k];
        if (periodic.periodic[k]) apart[k] -= period * std::round(apart[k] / period);
      }
      least = std::min(least, norm(apart));
    }
  bool const uneven_tank = GetParam().name == "uneven_tank_2d";
  EXPECT_GE(least, (uneven_tank ? 0.5 : 0.9) * dp);
}

// The normal is that of the face where the foot of the perpendicular is inside one face; zero where
// the place is behind an edge, or equally near to two sides.
TEST_P(DummyLayer, NormalsAreOfTheNearestSideAlone) {
  Surface const surface = make_box_surface(GetParam().wall, 9);
  BoxWall const& wall = GetParam().wall;
  auto const sides = closed_sides(wall);
  std::size_t with_normal = 0;
  for (Dummy const& dummy : dummies()) {
    int nearest_sides = 0;
    Vec3 expected{};
    double const least = -surface.distance(dummy.position).distance;
    for (BoxSide const& side : sides) {
      double const plane = (side.end == 0 ? wall.min : wall.max)[side.axis];
      double const behind = side.fluid_sign * (plane - dummy.position[side.axis]);
      if (std::fabs(behind - least) > 1e-12) continue;
      ++nearest_sides;
      expected = {};
      expected[side.axis] = side.fluid_sign;
    }
    if (nearest_sides != 1) expected = {};
    EXPECT_EQ(dummy.normal, expected);
    with_normal += norm(dummy.normal) > 0.0;
  }
  if (GetParam().name != "thinnest_block_2d") {
    EXPECT_GT(with_normal, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Layouts, DummyLayer, testing::ValuesIn(layouts()),
                         [](auto const& layout) { return layout.param.name; });

// With the particles that fill it on the same lattice, a tank and its wall are one even lattice.
TEST(DummyLayerLattice, ContinuesTheParticlesOfTheTank) {
  BoxWall const wall{.dimension = 2, .min = {-0.3, 0.2, 0}, .max = {0.2, 0.6, 0}};
  std::set<std::pair<long, long>> cells;
  auto const cell = [&](double x, double y) {
    double const i = (x - wall.min[0]) / dp - 0.5;
    double const j = (y - wall.min[1]) / dp - 0.5;
    EXPECT_NEAR(i, std::round(i), 1e-12);
    EXPECT_NEAR(j, std::round(j), 1e-12);
    return std::pair(std::lround(i), std::lround(j));
  };
  for (Dummy const& d : make_dummy_layer(wall, dp, 2, 0))
    EXPECT_TRUE(cells.insert(cell(d.position[0], d.position[1])).second);
  for (long i = 0; i < 5; ++i)
    for (long j = 0; j < 4; ++j) EXPECT_TRUE(cells.insert({i, j}).second);
  EXPECT_EQ(cells.size(), 9U * 8U);
  EXPECT_EQ(*cells.begin(), std::pair(-2L, -2L));
  EXPECT_EQ(*cells.rbegin(), std::pair(6L, 5L));
}

TEST(DummyLayerLattice, HasNothingBeyondAnOpenRim) {
  for (Dummy const& dummy :
       make_dummy_layer(with_open_top(box(2, {1.03, 0.47, 0}, SolidSide::outside)), dp, 3, 0))
    EXPECT_LT(dummy.position[1], 0.47);
}

// An obstacle in the middle of even fluid must not prefer a side.
TEST(DummyLayerLattice, OfAnObstacleIsSymmetric) {
  auto const all = make_dummy_layer(box(2, {1.04, 0.83, 0}, SolidSide::inside), dp, 3, 0);
  for (Dummy const& dummy : all) {
    auto const mirror = std::find_if(all.begin(), all.end(), [&](Dummy const& other) {
      return std::fabs(1.04 - dummy.position[0] - other.position[0]) < 1e-13 &&
             std::fabs(dummy.position[1] - other.position[1]) < 1e-13;
    });
    ASSERT_NE(mirror, all.end());
    EXPECT_NEAR(mirror->depth, dummy.depth, 1e-13);
    EXPECT_EQ(mirror->normal[0], -dummy.normal[0]);
    EXPECT_EQ(mirror->normal[1], dummy.normal[1]);
  }
}

std::string message_of(BoxWall const& wall, double spacing, int layers) {
  try {
    make_dummy_layer(wall, spacing, layers, 0);
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

TEST(DummyLayerInput, RefusesWhatCannotBeFilled) {
  BoxWall const wall = box(2, {1, 0.2, 0}, SolidSide::inside);
  EXPECT_EQ(message_of(wall, 0.0, 3), "box wall: the spacing must be positive");
  EXPECT_EQ(message_of(wall, dp, 0), "box wall: there must be at least one layer");
  EXPECT_EQ(message_of(wall, 0.25, 3),
            "box wall: on axis y the box is thinner than the particle spacing");
  EXPECT_EQ(message_of(box(2, {1, -0.2, 0}, SolidSide::inside), dp, 3),
            "box wall: on axis y the upper corner is not above the lower one");
}

}  // namespace
}  // namespace moraine
