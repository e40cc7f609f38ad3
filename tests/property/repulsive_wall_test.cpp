// Repulsive walls: what is thrown at them comes back, and the energy closes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "setup/build_model.hpp"
#include "setup/mirror_walls.hpp"
#include "step/simulation.hpp"
#include "terms/repulsion.hpp"

namespace moraine {
namespace {

constexpr double spacing = 0.02;  // m
constexpr double sound = 30.0;    // m/s

/// A block of 4^d particles of water that flies at `velocity` in the middle of a container of
/// 0.2 m, or above a solid of that size.
Case thrown_block(int dimension, WallForm form, WallMethod method, Point const& velocity) {
  Case c;
  c.dimension = dimension;
  c.domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = 1.5;
  c.numerics.precision = Precision::full;
  c.time.end = 1.0;
  Tait water;
  water.reference_sound_speed = sound;
  c.materials = {{"water", water}};
  RegionSpec block{"block", "water", Box{{}, {}}, {}};
  auto& box = std::get<Box>(block.shape);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    box.min[axis] = -0.04;
    box.max[axis] = 0.04;
  }
  if (form == WallForm::solid) {
    box.min[1] += 0.2;
    box.max[1] += 0.2;
  }
  block.initial.velocity = velocity;
  c.regions = {block};
  WallSpec wall;
  wall.name = "wall";
  wall.form = form;
  wall.box = {{-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}};
  wall.method = method;
  wall.repulsion = sound * sound;
  c.walls = {wall};
  end_domain_at_mirrors(c);
  return c;
}

/// How far in front of the wall's surface the worst particle is [m].
double nearest(WallForm form, ParticleStore const& store) {
  double least = 1.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double outside = -1.0;
    for (int axis = 0; axis < store.dimension(); ++axis)
      outside = std::max(outside, std::fabs(store.component(Field::position, axis)[i]) - 0.1);
    least = std::min(least, form == WallForm::container ? -outside : outside);
  }
  return least;
}

struct Throw {
  int dimension;
  WallForm form;
  WallMethod method;
  Point velocity;
};

class RepulsiveWalls : public testing::TestWithParam<Throw> {};

TEST_P(RepulsiveWalls, ThrowTheBlockBackAndKeepTheEnergy) {
  auto const [dimension, form, method, velocity] = GetParam();
  Simulation simulation(build_model(thrown_block(dimension, form, method, velocity)));
  ConservedSums const before = simulation.sums();
  EXPECT_EQ(before.potential_energy, 0.0);
  double pushed = 0.0;
  while (simulation.time() < 0.06) {
    simulation.advance();
    pushed = std::max(pushed, simulation.sums().potential_energy);
    ASSERT_GT(nearest(form, simulation.particles()), 0.0) << simulation.time();
  }
  ConservedSums const after = simulation.sums();
  EXPECT_GT(pushed, 0.0);
  EXPECT_LT(after.momentum[1], 0.5 * std::fabs(before.momentum[1]));  // it has met the wall
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(after.momentum[k] - before.momentum[k], after.wall_impulse[k],
                1e-10 * norm(before.momentum));
  // Second order in the step; particles turn round within a few steps.
  EXPECT_NEAR(after.total_energy() / before.total_energy(), 1.0, 0.01);
  EXPECT_EQ(simulation.lost().count, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    , RepulsiveWalls,
    testing::Values(
        Throw{2, WallForm::container, WallMethod::repulsive, {0.0, -5.0, 0.0}},
        Throw{2, WallForm::container, WallMethod::repulsive, {-5.0, -5.0, 0.0}},
        Throw{2, WallForm::container, WallMethod::mirror_and_repulsive, {0.0, -5.0, 0.0}},
        Throw{2, WallForm::solid, WallMethod::repulsive, {0.0, -5.0, 0.0}},
        Throw{3, WallForm::container, WallMethod::repulsive, {0.0, -5.0, 0.0}},
        Throw{3, WallForm::container, WallMethod::mirror_and_repulsive, {3.0, -5.0, 2.0}}));

// The force is the slope of the potential, the stiffness that of the force; both by differences of
// fourth order, 1e-4 of the distance apart, whose error is (1e-4)^4 of 10^5 or so.
TEST(Repulsion, ForceAndStiffnessAreSlopes) {
  for (double const r : {0.3, 0.6, 0.9, 0.999}) {
    double const d = 1e-4 * r;
    auto const slope = [d](auto const& f, double x) {
      return (8.0 * (f(x + d) - f(x - d)) - (f(x + 2.0 * d) - f(x - 2.0 * d))) / (12.0 * d);
    };
    auto const potential = [](double x) { return repulsion(7.0, 1.1, x * x).potential; };
    auto const force = [](double x) { return x * repulsion(7.0, 1.1, x * x).over_distance; };
    double const stiffness = repulsion(7.0, 1.1, r * r).stiffness;
    EXPECT_NEAR(-slope(potential, r) / force(r), 1.0, 1e-8);
    EXPECT_NEAR(-slope(force, r) / stiffness, 1.0, 1e-8);
  }
  EXPECT_NEAR(repulsion(7.0, 1.1, 1.21).potential, 0.0, 1e-15);  // 1/12 - 1/4 + 1/6, rounded
  EXPECT_EQ(repulsion(7.0, 1.1, 4.0).over_distance, 0.0);
}

// What a particle feels is that of all particles of the face one by one, inside, at edges, outside.
TEST(RepulsiveWall, FindsAllItsParticles) {
  BoxWall wall;
  wall.dimension = 3;
  wall.min = {0.0, 0.0, 0.0};
  wall.max = {0.4, 0.3, 0.2};
  wall.open[2][1] = true;
  std::size_t corners = 0;
  for (WallFace const& face : make_wall_faces(wall, 0.04, {2.0, 0.05}, {})) {
    auto const all = face_particles(face, 3);
    for (Vec3 const& x : all) {
      EXPECT_EQ(x[face.axis], face.low[face.axis]);
      corners += norm(x) < 1e-12 ? 1 : 0;
    }
    for (Vec3 const& place :
         {Vec3{0.01, 0.013, 0.017}, Vec3{0.2, 0.01, 0.1}, Vec3{0.39, 0.29, 0.19},
          Vec3{-0.01, 0.31, 0.21}, Vec3{0.2, 0.15, 0.1}}) {
      double direct = 0.0, found = 0.0;
      for (Vec3 const& x : all) {
        Vec3 const from = subtract(place, x);
        direct += repulsion(2.0, 0.05, dot(from, from)).potential;
      }
      for_each_repulsive_near(face, 3, place, [&](Vec3 const& x) {
        Vec3 const from = subtract(place, x);
        found += repulsion(2.0, 0.05, dot(from, from)).potential;
      });
      EXPECT_NEAR(found, direct, 1e-12 * direct);
    }
  }
  EXPECT_EQ(corners, 1u);  // of three faces that meet there
}

// A piston of repulsive particles gives the fluid what it is booked to give.
TEST(RepulsiveWall, PistonsDoTheWorkThatIsBooked) {
  Case c = thrown_block(2, WallForm::container, WallMethod::repulsive, {});
  c.domain = {{-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0}};
  RigidMotion& motion = c.walls[0].motion.motion.emplace();
  motion.translation[1] = TimeCourse::formula("0.03 * (1 - cos(60 * t))", 1e-5);
  motion.rotation = TimeCourse::formula("0.2 * sin(40 * t)", 1e-5);
  auto const error = [&](double step) {
    c.time.fixed_step = step;
    Simulation simulation(build_model(c));
    while (simulation.time() < 0.1) simulation.advance();
    EXPECT_GT(simulation.booked().walls, 1e-3);
    return std::fabs(simulation.sums().total_energy() - simulation.booked().walls) /
           simulation.booked().walls;
  };
  double const coarse = error(4e-5), fine = error(2e-5);
  EXPECT_LE(fine, 0.01);
  EXPECT_LE(fine, 0.5 * coarse + 1e-4);
}

}  // namespace
}  // namespace moraine
