// Particles that are thrown at faces, edges and corners of walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double rho_0 = 1000.0;  // kg/m^3, of the water

/// One particle of water at `start`, flying at `velocity`, in a container or outside a solid box of
/// 0.2 m.
Model thrown(int dimension, WallForm form, Point const& start, Point const& velocity) {
  Case c;
  c.dimension = dimension;
  c.domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  c.numerics.spacing = 0.02;
  c.numerics.smoothing_factor = 1.5;
  c.numerics.viscosity_alpha = 0.0;
  c.numerics.viscosity_beta = 0.0;
  c.numerics.precision = Precision::full;
  c.time.end = 1.0;
  Tait water;
  water.reference_sound_speed = 30.0;
  c.materials = {{"water", water}};
  RegionSpec drop{"drop", "water", Box{{}, {}}, {}};
  auto& box = std::get<Box>(drop.shape);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    box.min[axis] = form == WallForm::container ? 0.0 : 0.5;
    box.max[axis] = box.min[axis] + c.numerics.spacing;
  }
  drop.initial.velocity = velocity;
  c.regions = {drop};
  WallSpec wall;
  wall.name = "wall";
  wall.form = form;
  wall.box = {{-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}};
  c.walls = {wall};
  Model model = build_model(c);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    model.particles.component(Field::position, static_cast<int>(axis))[0] = start[axis];
  return model;
}

/// How far in front of the wall's surface a place is [m]; negative inside of the solid.
double ahead_of(WallForm form, int dimension, ParticleStore const& store) {
  double outside = -1.0;
  for (int axis = 0; axis < dimension; ++axis)
    outside = std::max(outside, std::fabs(store.component(Field::position, axis)[0]) - 0.1);
  return form == WallForm::container ? -outside : outside;
}

struct Throw {
  char const* name;
  int dimension;
  WallForm form;
  Point start;
  Point direction;
};

void PrintTo(Throw const& thrown, std::ostream* stream) { *stream << thrown.name; }

Throw const throws[] = {
    {"face_2d", 2, WallForm::container, {0.013, 0.0, 0.0}, {0.0, -1.0, 0.0}},
    {"corner_2d", 2, WallForm::container, {0.0, 0.0, 0.0}, {-1.0, -1.0, 0.0}},
    {"beside_corner_2d", 2, WallForm::container, {0.003, 0.0, 0.0}, {-1.0, -1.0, 0.0}},
    {"face_3d", 3, WallForm::container, {0.013, 0.0, 0.007}, {0.0, -1.0, 0.0}},
    {"edge_3d", 3, WallForm::container, {0.0, 0.0, 0.007}, {1.0, -1.0, 0.0}},
    {"corner_3d", 3, WallForm::container, {0.0, 0.0, 0.0}, {1.0, -1.0, 1.0}},
    {"face_of_block_2d", 2, WallForm::solid, {0.013, 0.2, 0.0}, {0.0, -1.0, 0.0}},
    {"corner_of_block_2d", 2, WallForm::solid, {0.2, 0.2, 0.0}, {-1.0, -1.0, 0.0}},
    {"beside_corner_of_block_2d", 2, WallForm::solid, {0.2, 0.203, 0.0}, {-1.0, -1.0, 0.0}},
    {"grazing_block_2d", 2, WallForm::solid, {0.2, 0.097, 0.0}, {-1.0, 0.0, 0.0}},
    {"flat_over_corner_of_block_2d", 2, WallForm::solid, {0.2, 0.13, 0.0}, {-1.0, -0.3, 0.0}},
    {"face_of_block_3d", 3, WallForm::solid, {0.013, 0.2, 0.007}, {0.0, -1.0, 0.0}},
    {"edge_of_block_3d", 3, WallForm::solid, {0.2, 0.2, 0.007}, {-1.0, -1.0, 0.0}},
    {"beside_edge_of_block_3d", 3, WallForm::solid, {0.2, 0.203, 0.007}, {-1.0, -1.0, 0.0}},
    {"corner_of_block_3d", 3, WallForm::solid, {0.2, 0.2, 0.2}, {-1.0, -1.0, -1.0}},
    {"beside_corner_of_block_3d", 3, WallForm::solid, {0.2, 0.203, 0.205}, {-1.0, -1.0, -1.0}},
};

struct Flight {
  double nearest = 1.0;  // m, in front of the surface
  double end = 0.0;      // m, the same at the end
  double energy_gain = 0.0;
};

Flight fly(Throw const& t, double speed, double density) {
  Point velocity{};
  for (std::size_t axis = 0; axis < 3; ++axis) velocity[axis] = speed * t.direction[axis];
  Model model = thrown(t.dimension, t.form, t.start, velocity);
  model.particles.scalar(Field::density)[0] = density;
  model.time.end = 0.2 / speed;
  // A single particle that meets a face is all the energy of its run, and the face gives it a part
  // of that, up to two thirds (energy_gain).
  model.guards.off = {"budget"};
  Simulation simulation(std::move(model));
  double const energy = simulation.sums().total_energy();
  Flight flight;
  while (simulation.running()) {
    simulation.advance();
    flight.end = ahead_of(t.form, t.dimension, simulation.particles());
    flight.nearest = std::min(flight.nearest, flight.end);
  }
  flight.energy_gain = simulation.sums().total_energy() / energy - 1.0;
  return flight;
}

class ThrownAtWall : public testing::TestWithParam<Throw> {};

// Up to a tenth of the speed of sound along each axis, the range of weakly compressible flow.
TEST_P(ThrownAtWall, StaysOutsideOfTheSolid) {
  for (double const speed : {0.3, 1.5, 3.0}) {
    Flight const flight = fly(GetParam(), speed, rho_0);
    EXPECT_GT(flight.nearest, 0.0) << speed << " m/s";
    EXPECT_LT(flight.nearest, 0.04) << "it was there";
    // The walls are at rest: the time integration's error, 3e-3 at the largest speed.
    EXPECT_NEAR(flight.energy_gain, 0.0, 5e-3) << speed << " m/s";
  }
}

// Three times as fast: into a convex corner by less than half a spacing, and out again.
TEST_P(ThrownAtWall, ComesBackWhenMuchTooFast) {
  Flight const flight = fly(GetParam(), 9.0, rho_0);
  EXPECT_GT(flight.nearest, -0.01);
  EXPECT_GT(flight.end, 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, ThrownAtWall, testing::ValuesIn(throws),
                         [](auto const& at) { return std::string(at.param.name); });

// A particle that remembers twice its volume has no pressure to stop it before the face: the
// contact does, within its gap of a quarter of a spacing.
TEST(WallContact, StopsParticlesWithoutPressure) {
  int faces = 0;
  for (Throw const& at : throws) {
    if (std::string(at.name).rfind("face", 0) != 0) continue;
    ++faces;
    for (double const speed : {0.3, 1.5, 3.0}) {
      SCOPED_TRACE(std::string(at.name) + ", m/s: " + std::to_string(speed));
      Flight const flight = fly(at, speed, 0.5 * rho_0);
      EXPECT_LT(flight.nearest, 0.005);
      EXPECT_GT(flight.nearest, 0.0025) << "measured 0.0030 to 0.0048";
      EXPECT_GT(flight.end, 0.05);
    }
  }
  EXPECT_EQ(faces, 4);
}

// One particle without pressure in front of a floor; contact_gap is a quarter of the spacing, 5 mm.
TEST(WallContact, ActsWithinItsGapOnly) {
  for (int const dimension : {2, 3})
    for (double const gap : {0.0049, 0.0051, 0.01, 0.03}) {
      Model model = thrown(dimension, WallForm::container, {0.003, gap - 0.1, 0.001}, {});
      Simulation const simulation(std::move(model));
      ParticleStore const& store = simulation.particles();
      ASSERT_EQ(store.scalar(Field::pressure)[0], 0.0);
      double const up = store.component(Field::acceleration, 1)[0];
      EXPECT_EQ(up > 0.0, gap < 0.005) << gap;
      for (int axis = 0; axis < dimension; ++axis)
        EXPECT_LE(std::fabs(store.component(Field::acceleration, axis)[0]), up) << gap;
    }
}

// The strip beside an edge of a block is too far from the wall particles that know the face. The
// wall particle behind the edge, 10 mm from both faces, stands for the ball about it that touches
// them.
TEST(WallContact, ActsBesideEdges) {
  for (int const dimension : {2, 3})
    for (double const inside : {0.0, 0.002, 0.004, 0.008})
      for (double const height : {0.001, 0.004, 0.012}) {
        Point const place{0.1 - inside, 0.1 + height, 0.01};
        double const gap = std::hypot(place[0] - 0.09, place[1] - 0.09) - 0.01;
        Simulation const simulation(thrown(dimension, WallForm::solid, place, {}));
        ParticleStore const& store = simulation.particles();
        ASSERT_EQ(store.scalar(Field::pressure)[0], 0.0);
        SCOPED_TRACE(std::to_string(dimension) + "D, inside " + std::to_string(inside) + " above " +
                     std::to_string(height));
        EXPECT_EQ(store.component(Field::acceleration, 1)[0] > 0.0, gap < 0.005);
        EXPECT_GE(store.component(Field::acceleration, 0)[0], 0.0) << "outwards";
      }
}

}  // namespace
}  // namespace moraine
