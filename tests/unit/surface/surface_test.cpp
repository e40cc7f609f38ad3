#include "surface/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace moraine {
namespace {

void expect_near(Vec3 const& a, Vec3 const& b, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "component " << k;
}

// Triangle strip around an L-shaped bar (not convex), extruded along z from 0 to 1: solid where
// (x, y) is in [0,2]x[0,1] or [0,1]x[0,2] and 0 < z < 1.
Surface l_shaped_bar() {
  std::vector<Vec3> const outline{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  std::vector<Vec3> vertices = outline;
  for (Vec3 const& x : outline) vertices.push_back({x[0], x[1], 1.0});
  std::vector<Face> faces;
  for (std::uint32_t k = 0; k < 6; ++k) {
    std::uint32_t const next = (k + 1) % 6;
    faces.push_back({{k, next, next + 6}});
    faces.push_back({{k, next + 6, k + 6}});
  }
  for (std::uint32_t const lid : {0U, 6U})
    for (auto const& [a, b, c] : {std::array{0U, 1U, 2U}, std::array{0U, 2U, 3U},
                                  std::array{0U, 3U, 5U}, std::array{3U, 4U, 5U}})
      faces.push_back({{a + lid, b + lid, c + lid}, lid == 0 ? -1 : +1});
  return Surface(3, 0, vertices, faces);
}

Surface triangle(int side) {
  return Surface(3, 4, {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}, side}});
}

TEST(Surface, NormalsAndAreas) {
  Surface const point(1, 7, {{3, 0, 0}}, {{{0}, -1}});
  expect_near(point.normal(0), {-1, 0, 0}, 0.0);
  EXPECT_EQ(point.area(0), 1.0);
  EXPECT_EQ(point.owner(), 7U);

  Surface const segment(2, 0, {{0, 0, 0}, {3, 4, 0}}, {{{0, 1}}});
  expect_near(segment.normal(0), {-0.8, 0.6, 0}, 1e-15);
  EXPECT_DOUBLE_EQ(segment.area(0), 5.0);

  expect_near(triangle(+1).normal(0), {0, 0, 1}, 0.0);
  expect_near(triangle(-1).normal(0), {0, 0, -1}, 0.0);
  EXPECT_DOUBLE_EQ(triangle(-1).area(0), 1.0);
}

TEST(Surface, SampleGivesThePlaceBehindTheFace) {
  Surface const face = triangle(-1);
  expect_near(face.sample(0, {0.25, 0.5}, 0.125).position, {0.5, 0.5, 0.125}, 1e-15);
  // Coordinates beyond the face continue its plane.
  expect_near(face.sample(0, {-0.5, 2.0}, 0.0).position, {-1.0, 2.0, 0.0}, 1e-15);
}

// A rigid motion v = v0 + w x x has the same form for every place bound to the face, at any depth.
TEST(Surface, SampleOfARigidMotionIsRigid) {
  Vec3 const v0{0.5, -1.0, 2.0};
  Vec3 const w{0.3, -0.7, 1.1};
  Surface face(3, 0, {{0.1, 0.2, 0.3}, {1.5, 0.4, -0.2}, {0.3, 1.9, 0.8}}, {{{0, 1, 2}, -1}});
  for (std::size_t k = 0; k < 3; ++k) {
    face.velocity()[k] = add(v0, cross(w, face.position()[k]));
    face.acceleration()[k] = {1.0, 2.0, 3.0};
  }
  for (double const depth : {-0.4, 0.0, 0.7}) {
    SurfaceSample const sample = face.sample(0, {0.2, 0.3}, depth);
    expect_near(sample.velocity, add(v0, cross(w, sample.position)), 1e-14);
    expect_near(sample.acceleration, {1.0, 2.0, 3.0}, 1e-14);
  }
  Surface line(2, 0, {{0.1, 0.2, 0}, {1.5, 0.4, 0}}, {{{0, 1}, +1}});
  for (std::size_t k = 0; k < 2; ++k) line.velocity()[k] = cross({0, 0, 2.0}, line.position()[k]);
  SurfaceSample const sample = line.sample(0, {0.2, 0.0}, 0.5);
  expect_near(sample.velocity, cross({0, 0, 2.0}, sample.position), 1e-14);
}

TEST(Surface, ForcesKeepSumMomentAndPower) {
  Surface face = triangle(+1);
  face.velocity()[0] = {1, 2, 3};
  face.velocity()[1] = {-2, 0, 1};
  face.velocity()[2] = {0, 5, -1};
  Vec3 const force{3, -4, 10};
  FaceCoordinates const uv{0.2, 0.5};
  face.add_force(0, uv, force);
  Vec3 sum{};
  Vec3 moment{};
  double power = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum = add(sum, face.force()[k]);
    moment = add(moment, cross(face.position()[k], face.force()[k]));
    power += dot(face.velocity()[k], face.force()[k]);
  }
  SurfaceSample const place = face.sample(0, uv, 0.0);
  expect_near(sum, force, 1e-14);
  expect_near(moment, cross(place.position, force), 1e-14);
  EXPECT_NEAR(power, dot(place.velocity, force), 1e-13);
  face.clear_forces();
  for (Vec3 const& f : face.force()) expect_near(f, {}, 0.0);
}

// Random points near a body with a reentrant edge: the side follows from its shape.
TEST(Surface, SideOfABodyThatIsNotConvex) {
  Surface const bar = l_shaped_bar();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.0, 3.0);
  int inside_count = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    Vec3 const x{coordinate(random), coordinate(random), 0.5 * coordinate(random)};
    bool const in_l = x[0] > 0 && x[1] > 0 && x[0] < 2 && x[1] < 2 && (x[0] < 1 || x[1] < 1);
    bool const inside = in_l && x[2] > 0 && x[2] < 1;
    inside_count += inside;
    EXPECT_EQ(bar.inside_solid(x), inside) << x[0] << " " << x[1] << " " << x[2];
  }
  EXPECT_GT(inside_count, 300);
}

TEST(Surface, DistanceToFaceEdgeAndCorner) {
  Surface const bar = l_shaped_bar();
  EXPECT_NEAR(bar.distance({0.5, -0.25, 0.5}).distance, 0.25, 1e-14);
  EXPECT_NEAR(bar.distance({2.3, -0.4, 0.5}).distance, 0.5, 1e-14);
  EXPECT_NEAR(bar.distance({-0.2, -0.3, 1.6}).distance, 0.7, 1e-14);
  EXPECT_NEAR(bar.distance({0.5, 0.2, 0.5}).distance, -0.2, 1e-14);
  SurfaceDistance const nearest = bar.distance({0.9, 1.8, 1.25});
  expect_near(bar.sample(nearest.face, nearest.uv, 0.0).position, nearest.position, 1e-14);
  expect_near(nearest.position, {0.9, 1.8, 1.0}, 1e-14);
}

// A tank without a lid: the walls count as continued upwards, and above it is fluid.
TEST(Surface, OpenTank) {
  Surface const tank(2, 0, {{0, 1, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}},
                     {{{0, 1}}, {{1, 2}}, {{2, 3}}});
  expect_near(tank.normal(0), {1, 0, 0}, 0.0);
  EXPECT_FALSE(tank.inside_solid({1.0, 0.5, 0}));
  EXPECT_FALSE(tank.inside_solid({0.1, 1.5, 0}));
  EXPECT_TRUE(tank.inside_solid({-0.1, 1.5, 0}));
  EXPECT_TRUE(tank.inside_solid({-0.1, -0.1, 0}));
  EXPECT_TRUE(tank.inside_solid({1.0, -0.1, 0}));
}

TEST(Surface, OneDimension) {
  Surface const pipe(1, 0, {{0, 0, 0}, {5, 0, 0}}, {{{0}, +1}, {{1}, -1}});
  EXPECT_DOUBLE_EQ(pipe.distance({1, 0, 0}).distance, 1.0);
  EXPECT_DOUBLE_EQ(pipe.distance({-1, 0, 0}).distance, -1.0);
  EXPECT_DOUBLE_EQ(pipe.distance({7, 0, 0}).distance, -2.0);
  EXPECT_EQ(pipe.distance({7, 0, 0}).face, 1U);
}

std::string message_of(int dimension, std::vector<Vec3> vertices, std::vector<Face> faces) {
  try {
    Surface const surface(dimension, 0, std::move(vertices), std::move(faces));
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

TEST(Surface, RefusesWhatIsNoSurface) {
  std::vector<Vec3> const two{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(message_of(4, two, {{{0}}}), "surface: the dimension must be 1, 2 or 3");
  EXPECT_EQ(message_of(2, two, {}), "surface: there are no faces");
  EXPECT_EQ(message_of(2, two, {{{0, 2}}}), "surface: face 0 has a corner that does not exist");
  EXPECT_EQ(message_of(2, two, {{{0, 1}}, {{0, 1}, 0}}), "surface: face 1 must have side +1 or -1");
  EXPECT_EQ(message_of(2, two, {{{1, 1}}}), "surface: face 0 has no extent");
}

}  // namespace
}  // namespace moraine
