// Walls that move as prescribed, against motions whose effect is known exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "exact/hugoniot.hpp"
#include "setup/build_model.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

RigidMotion along_x(std::string const& formula) {
  RigidMotion motion;
  motion.translation[0] = TimeCourse::formula(formula, 1e-4);
  return motion;
}

/// A closed 2D tank of water with a free surface; `motion` moves the tank.
Case tank(Precision precision) {
  Case c;
  c.dimension = 2;
  c.domain = {{-1.0, -1.0, 0.0}, {2.0, 2.0, 0.0}};
  c.numerics.spacing = 0.02;
  c.numerics.viscosity_alpha = 0.1;
  c.numerics.viscosity_beta = 0.0;
  c.numerics.density_diffusion = 0.1;
  c.numerics.precision = precision;
  c.time.end = 10.0;
  c.time.fixed_step = 2e-4;
  Tait water;
  water.reference_sound_speed = 25.0;
  c.materials = {{"water", water}};
  c.regions = {{"water", "water", Box{{0.0, 0.0, 0.0}, {0.6, 0.3, 0.0}}, {}}};
  WallSpec wall;
  wall.name = "tank";
  wall.box = {{0.0, 0.0, 0.0}, {0.6, 0.5, 0.0}};
  c.walls = {wall};
  return c;
}

/// Places and velocities by id, seen from a frame displaced by x and moving with v along x.
std::vector<double> seen_from(Simulation const& simulation, double x, double v) {
  ParticleStore const& store = simulation.particles();
  Range const fluid = store.range(Kind::fluid);
  std::vector<double> seen(4 * fluid.size());
  for (std::size_t i = fluid.begin; i < fluid.end; ++i) {
    double* const to = &seen[4 * store.id()[i]];
    to[0] = store.component(Field::position, 0)[i] - x;
    to[1] = store.component(Field::position, 1)[i];
    to[2] = store.component(Field::velocity, 0)[i] - v;
    to[3] = store.component(Field::velocity, 1)[i];
  }
  return seen;
}

double largest_difference(std::vector<double> const& a, std::vector<double> const& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::fabs(a[k] - b[k]));
  return worst;
}

// Galilei: a tank that travels is a tank at rest.
TEST(MovingWall, SteadyTravelChangesNothing) {
  Case const c = tank(Precision::full);
  Simulation rest(build_model(c));
  Case moved = c;
  moved.walls[0].motion.motion = along_x("1.5 * t");
  moved.regions[0].initial.velocity = {1.5, 0.0, 0.0};
  moved.domain.max[0] = 3.0;
  Simulation moving(build_model(moved));
  for (int step = 0; step < 1000; ++step) {
    rest.advance();
    moving.advance();
  }
  EXPECT_LE(largest_difference(seen_from(rest, 0.0, 0.0), seen_from(moving, 0.3, 1.5)), 1e-7);
}

// The same along a periodic axis: three times around, and water that drags on the bed is where it
// is over a bed at rest.
TEST(MovingWall, SlidesAlongAPeriod) {
  Case c = tank(Precision::full);
  c.domain = {{0.0, -0.3, 0.0}, {0.6, 0.8, 0.0}};
  c.periodic = {true, false, false};
  c.gravity = {0.0, -9.81, 0.0};
  c.walls[0].slip = Slip::none;
  c.numerics.physical_viscosity = ViscosityForm::morris;
  c.materials[0].dynamic_viscosity = 20.0;
  c.regions[0].initial.velocity = {0.5, 0.0, 0.0};
  Simulation rest(build_model(c));
  c.walls[0].motion.motion = along_x("9 * t");
  c.regions[0].initial.velocity = {9.5, 0.0, 0.0};
  Simulation moving(build_model(c));
  for (int step = 0; step < 1000; ++step) {
    rest.advance();
    moving.advance();
  }
  auto const one = seen_from(rest, 0.0, 0.0);
  auto two = seen_from(moving, 1.8, 9.0);
  for (std::size_t k = 0; k < two.size(); k += 4)
    two[k] = one[k] + std::remainder(two[k] - one[k], 0.6);
  EXPECT_LE(largest_difference(one, two), 1e-7);
  EXPECT_LT(rest.sums().momentum[0], 0.49 * rest.sums().mass);
}

// Einstein: a tank that is accelerated is a tank at rest in a field of the opposite acceleration.
// The integration of a uniform acceleration is exact; what differs is rounding.
TEST(MovingWall, AccelerationIsGravityTheOtherWay) {
  // Without density diffusion: its correction for the pressure at rest knows gravity alone.
  double const a = 3.0;
  Case field = tank(Precision::full);
  field.numerics.density_diffusion = 0.0;
  field.gravity = {-a, -9.81, 0.0};
  Simulation rest(build_model(field));
  Case shaken = field;
  shaken.gravity = {0.0, -9.81, 0.0};
  shaken.walls[0].motion.motion = along_x("1.5 * t^2");
  Simulation moving(build_model(shaken));
  for (int step = 0; step < 1000; ++step) {
    rest.advance();
    moving.advance();
  }
  double const t = moving.time();
  EXPECT_NEAR(t, 0.2, 1e-12);
  auto const seen = seen_from(moving, 0.5 * a * t * t, a * t);
  auto const still = seen_from(rest, 0.0, 0.0);
  Case const calm = tank(Precision::full);
  EXPECT_GE(largest_difference(still, seen_from(Simulation(build_model(calm)), 0.0, 0.0)), 0.01);
  EXPECT_LE(largest_difference(still, seen), 1e-6);
}

// Water that turns with its full tank stays where it is in the tank; its pressure rises outwards by
// 1/2 rho omega^2 r^2, above a pressure in the middle that keeps it from tension.
TEST(MovingWall, WaterTurnsWithItsTank) {
  double const omega = 2.0;      // rad/s
  double const middle = 2000.0;  // Pa
  Case c = tank(Precision::full);
  c.numerics.smoothing_factor = 2.0;
  c.numerics.density_diffusion = 0.0;  // it would wear down what is no pressure of gravity
  c.walls[0].box = {{-0.3, -0.3, 0.0}, {0.3, 0.3, 0.0}};
  c.regions[0].shape = c.walls[0].box;
  c.regions[0].initial.rotation.rate = omega;
  c.walls[0].motion.motion.emplace();
  c.walls[0].motion.motion->rotation = TimeCourse::formula("2 * t", 1e-4);
  Model model = build_model(c);
  ParticleStore& store = model.particles;
  Tait const& water = std::get<Tait>(c.materials[0].eos);
  std::vector<std::array<double, 2>> start(store.size());
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    double const y = store.component(Field::position, 1)[i];
    start[store.id()[i]] = {x, y};
    store.scalar(Field::density)[i] =
        water.density_at_pressure(middle + 500.0 * omega * omega * (x * x + y * y), 0.0);
    store.scalar(Field::mass)[i] =
        store.scalar(Field::density)[i] * c.numerics.spacing * c.numerics.spacing;
  }
  Simulation simulation(std::move(model));
  while (simulation.time() < 0.5 * std::numbers::pi / omega) simulation.advance();
  double const angle = omega * simulation.time();
  ParticleStore const& now = simulation.particles();
  double farthest = 0.0, pressure_error = 0.0;
  for (std::size_t i = 0; i < now.range(Kind::fluid).size(); ++i) {
    auto const [x_0, y_0] = start[now.id()[i]];
    double const x = now.component(Field::position, 0)[i];
    double const y = now.component(Field::position, 1)[i];
    farthest = std::max(farthest, std::hypot(x - (x_0 * std::cos(angle) - y_0 * std::sin(angle)),
                                             y - (x_0 * std::sin(angle) + y_0 * std::cos(angle))));
    double const exact = middle + 500.0 * omega * omega * (x * x + y * y);
    pressure_error = std::max(pressure_error, std::fabs(now.scalar(Field::pressure)[i] - exact));
  }
  double const span = 500.0 * omega * omega * 0.18;  // Pa, centre to corner
  EXPECT_LE(farthest, 0.01 * c.numerics.spacing);
  EXPECT_LE(pressure_error / span, 0.05);
}

// A wall that a stage has removed limits no step any more.
TEST(MovingWall, RemovedWallsDoNotVote) {
  Case c = tank(Precision::full);
  c.time.fixed_step = 0.0;
  WallSpec gate;
  gate.name = "gate";
  gate.form = WallForm::solid;
  gate.box = {{0.2, 0.6, 0.0}, {0.4, 0.7, 0.0}};
  gate.motion.motion.emplace();
  gate.motion.motion->translation[1] = TimeCourse::formula("200 * t", 1e-6);
  c.walls.push_back(gate);
  c.stages.resize(2);
  c.stages[0].name = "lift";
  c.stages[0].until.after = 1e-3;
  c.stages[1].name = "free";
  c.stages[1].remove_wall = "gate";
  Simulation simulation(build_model(c));
  simulation.advance();
  EXPECT_EQ(simulation.vote().reason, wall_motion_limit);
  while (simulation.stages_to_come() > 0) simulation.advance();
  simulation.advance();
  EXPECT_NE(simulation.vote().reason, wall_motion_limit);
}

// A piston of constant speed in water at rest drives a shock whose pressure is the Hugoniot's.
TEST(MovingWall, PistonDrivesTheShockOfItsHugoniot) {
  double const speed = 500.0;
  Case c;
  c.dimension = 1;
  c.domain = {{-0.5, 0.0, 0.0}, {4.0, 0.0, 0.0}};
  c.numerics.spacing = 0.005;
  c.numerics.viscosity_alpha = 1.0;
  c.numerics.viscosity_beta = 2.0;
  c.time.end = 6e-4;
  c.materials = {{"water", WaterPolynomial{}}};
  c.regions = {{"water", "water", Box{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}, {}}};
  WallSpec piston;
  piston.name = "piston";
  piston.form = WallForm::solid;
  piston.box = {{-0.1, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  RigidMotion motion;
  motion.translation[0] = TimeCourse::formula("500 * t", 1e-7);
  piston.motion.motion = motion;
  c.walls = {piston};
  Simulation simulation(build_model(c));
  double const before = simulation.sums().total_energy();
  while (simulation.running()) simulation.advance();
  WaterPolynomial const water;
  ShockState const exact =
      shock_from_piston(water, water.reference_density, water.reference_energy, speed);
  double pressure = 0.0, count = 0.0;
  ParticleStore const& store = simulation.particles();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    if (x < 0.45 || x > 0.8) continue;  // between the piston (0.3 m) and the shock (1.3 m)
    pressure += store.scalar(Field::pressure)[i];
    count += 1.0;
  }
  ASSERT_GT(count, 20.0);
  EXPECT_NEAR(pressure / count / exact.pressure, 1.0, 0.01);
  // The work of the piston is the energy of the water: the force on it times its way.
  double const gained = simulation.sums().total_energy() - before;
  EXPECT_NEAR(simulation.booked().walls / gained, 1.0, 1e-3);
  double const force = simulation.sums().wall_impulse[0] / simulation.time();
  EXPECT_NEAR(force / exact.pressure, 1.0, 0.03);
}

}  // namespace
}  // namespace moraine
