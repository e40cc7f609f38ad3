// What optional terms are for, and what they must keep.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "support/option_reference.hpp"
#include "support/small_models.hpp"
#include "terms/options/moments.hpp"

namespace moraine {
namespace {

/// A disordered periodic block of one liquid at its reference density, double precision.
Model one_liquid(int dimension) {
  RandomBox box;
  box.dimension = dimension;
  box.side = dimension == 3 ? 10 : 24;
  box.scheme = SchemeName::liquid;
  Model model = random_box(box, 1.0);
  model.numerics.viscosity_alpha = model.numerics.viscosity_beta = 0.0;
  for (double& rho : model.particles.scalar(Field::density)) rho = 1000.0;
  return model;
}

/// Whether a particle lies `reach` smoothing lengths from the sides of the domain.
bool is_inner(Model const& model, std::size_t i, double reach) {
  double const margin = reach * model.numerics.smoothing_length();
  for (int axis = 0; axis < model.dimension; ++axis) {
    auto const a = static_cast<std::size_t>(axis);
    double const x = model.particles.component(Field::position, axis)[i];
    if (x < model.domain_min[a] + margin || x > model.domain_max[a] - margin) return false;
  }
  return true;
}

// In the volume form d rho / dt = - rho div v to rounding, whatever the disorder.
TEST(CorrectedGradient, IsExactForLinearVelocities) {
  for (int const dimension : {2, 3}) {
    Model model = one_liquid(dimension);
    model.numerics.continuity = ContinuityForm::volume;
    model.numerics.gradient_correction = GradientCorrection::bonet_lok;
    ParticleStore& store = model.particles;
    for (int axis = 0; axis < dimension; ++axis)
      for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
        store.component(Field::velocity, axis)[i] =
            (1.0 + axis) * store.component(Field::position, axis)[i] +
            0.7 * store.component(Field::position, (axis + 1) % dimension)[i];
    find_rates(model);
    double const exact = -1000.0 * dimension * (dimension + 1) / 2.0;
    int seen = 0;
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
      if (!is_inner(model, i, 2.0)) continue;
      ++seen;
      EXPECT_NEAR(store.scalar(Field::density_rate)[i], exact, 1e-9 * std::fabs(exact)) << i;
    }
    EXPECT_GT(seen, 0);
  }
}

// Of a linear density the gradient form diffuses only what the softening phi makes of close pairs;
// the hydrostatic form, which knows gravity alone, diffuses it.
TEST(GradientDiffusion, LeavesALinearDensityAlone) {
  auto const most = [](DiffusionForm form) {
    Model model = one_liquid(2);
    model.numerics.density_diffusion = 0.1;
    model.numerics.diffusion = form;
    model.numerics.physical_viscosity = ViscosityForm::morris;  // an option in both cases
    ParticleStore& store = model.particles;
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
      for (int axis = 0; axis < 2; ++axis) store.component(Field::velocity, axis)[i] = 0.0;
      store.scalar(Field::sound_speed)[i] = 100.0;
      store.scalar(Field::density)[i] =
          1000.0 * (1.0 + 0.1 * store.component(Field::position, 0)[i]);
    }
    find_rates(model);
    double largest = 0.0;
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
      if (is_inner(model, i, 4.0))
        largest = std::max(largest, std::fabs(store.scalar(Field::density_rate)[i]));
    return largest;
  };
  EXPECT_LT(most(DiffusionForm::gradient), 0.06 * most(DiffusionForm::hydrostatic));
}

// Shifting must even out what disorder there is.
TEST(Shifting, PointsWhereParticlesAreFewer) {
  Model model = one_liquid(2);
  model.numerics.shifting = 2.0;
  ParticleStore& store = model.particles;
  store.use(Field::drift);
  double along = 0.0;
  find_rates(model);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    PlainPair const* nearest = nullptr;
    auto const pairs = plain_pairs(model, i);
    double least = 1.0;
    for (PlainPair const& pair : pairs)
      if (double const r2 = pair.x[0] * pair.x[0] + pair.x[1] * pair.x[1]; r2 < least) {
        least = r2;
        nearest = &pair;
      }
    for (std::size_t a = 0; a < 2; ++a)
      along +=
          nearest->x[a] * store.component(Field::drift, static_cast<int>(a))[i] / std::sqrt(least);
  }
  EXPECT_GT(along, 0.0);  // away from the nearest neighbour, on the whole
}

TEST(Moments, CorrectionFadesWhereNeighboursAreFew) {
  Symmetric<2> const inside = gradient_correction<2>({0.8, 1.1, 0.05});
  EXPECT_NEAR(inside[0], 1.1 / (0.8 * 1.1 - 0.0025) - 1.0, 1e-12);
  EXPECT_NEAR(inside[2], -0.05 / (0.8 * 1.1 - 0.0025), 1e-12);
  for (double const entry : gradient_correction<2>({1.0, 0.1, 0.0})) EXPECT_EQ(entry, 0.0);
  for (double const entry : gradient_correction<3>({0.0, 0.0, 0.0, 0.0, 0.0, 0.0}))
    EXPECT_EQ(entry, 0.0);
}

/// A block of two liquids that run into each other at 2 m/s.
Model two_blocks(double strength, double time_step) {
  Model model = build_model(parse_case(R"(
space.dimension = 2
space.domain = { min = [-1, -1], max = [1, 1] }
resolution.spacing = 0.02
numerics = { viscosity_alpha = 0, viscosity_beta = 0, precision = "double" }
time.end = 0.02
[material.left]
eos = "tait"
reference_sound_speed = 40
[material.right]
eos = "tait"
reference_sound_speed = 40
[[region]]
name = "one"
material = "left"
velocity = [1, 0]
box = { min = [-0.2, -0.2], max = [0, 0.2] }
[[region]]
name = "other"
material = "right"
velocity = [-1, 0]
box = { min = [0, -0.2], max = [0.2, 0.2] }
)",
                                       "blocks"));
  model.numerics.penalty.strength = strength;
  model.time.fixed_step = time_step;
  return model;
}

/// Largest speed of shifting over the particles that counts() takes, in a sheared block of water
/// with free sides, 20 particles across.
template <class Counts>
double most_shifted(Counts counts) {
  Model model = two_blocks(0.0, 0.0);
  model.numerics.shifting = 20.0;
  ParticleStore& store = model.particles;
  store.use(Field::drift);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    store.component(Field::velocity, 0)[i] = store.component(Field::position, 1)[i];
  find_rates(model);
  double most = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (counts(std::array{store.component(Field::position, 0)[i],
                          store.component(Field::position, 1)[i]}))
      for (int axis = 0; axis < 2; ++axis)
        most = std::max(most, std::fabs(store.component(Field::drift, axis)[i]));
  return most;
}

/// Spacings from a place to the nearest side of the block of two_blocks.
double depth_of(std::array<double, 2> const& x) {
  return (0.2 - std::max(std::fabs(x[0]), std::fabs(x[1]))) / 0.02;
}

// Pairs run by each other at up to 2 h |grad v| = 0.048 m/s. Inside the sums cancel to rounding;
// the kernel reaches 2.4 spacings. In the first row, half a spacing deep, tr M is about half of
// what it is inside, and the factor is zero there.
TEST(Shifting, LeavesAnEvenLatticeAndAFreeSurfaceAlone) {
  EXPECT_LT(most_shifted([](auto const& x) { return depth_of(x) > 2.5; }), 1e-12);
  EXPECT_EQ(most_shifted([](auto const& x) { return depth_of(x) < 1.0; }), 0.0);
  EXPECT_GT(most_shifted([](auto const&) { return true; }), 0.0) << "the second row";
}

// U counts: what is left of the change of the total energy falls with the square of the time step.
TEST(Penalty, ItsPotentialClosesTheEnergy) {
  auto const error = [](double time_step, double& stored) {
    Simulation simulation(two_blocks(200.0, time_step));
    double const start = simulation.sums().total_energy();
    EXPECT_EQ(simulation.sums().penalty_energy, 0.0);  // nothing pushes at rest on a lattice
    while (simulation.running()) {
      simulation.advance();
      stored = std::max(stored, simulation.sums().penalty_energy);
    }
    return std::fabs(simulation.sums().total_energy() - start);
  };
  double stored = 0.0;
  double const coarse = error(4e-5, stored), fine = error(2e-5, stored);
  EXPECT_GT(stored, 0.1);  // J; the kinetic energy is 80 J
  EXPECT_LT(coarse, 0.05 * stored);
  EXPECT_LT(fine, 0.4 * coarse);
}

// A group may be named after one of its materials.
TEST(Penalty, LeavesMaterialsOfOneGroupTogether) {
  auto const end = [](double strength, std::string const& group) {
    Model model = two_blocks(strength, 4e-5);
    model.materials[1].penalty_group = group;
    Simulation simulation(std::move(model));
    for (int step = 0; step < 200; ++step) simulation.advance();
    return state_by_id(simulation.particles());
  };
  auto const without = end(0.0, "");
  EXPECT_EQ(end(200.0, "left"), without);
  EXPECT_NE(end(200.0, ""), without);
  EXPECT_NE(end(200.0, "stone"), without);
}

TEST(Penalty, LimitsTheTimeStepWhereItIsStiff) {
  Simulation simulation(two_blocks(1e6, 0.0));
  bool limited = false;
  for (int step = 0; step < 40; ++step) {
    simulation.advance();
    limited = limited || simulation.vote().reason == penalty_limit;
  }
  EXPECT_TRUE(limited);
}

/// A square of water between plates without slip, which a force along them drives.
Model channel(std::string const& slip) {
  return build_model(parse_case(R"(
space.dimension = 2
space.domain = { min = [0, -0.4], max = [0.5, 1.4] }
space.periodic = ["x"]
resolution = { spacing = 0.05, smoothing_factor = 1.5 }
numerics = { viscosity_alpha = 0, viscosity_beta = 0, precision = "double", physical_viscosity = "morris" }
physics.gravity = [0.1, 0]
time.end = 20
[material.oil]
eos = "tait"
reference_sound_speed = 2
dynamic_viscosity = 100
[[region]]
name = "oil"
material = "oil"
box = { min = [0, 0], max = [0.5, 1] }
[[wall]]
name = "plates"
container = { min = [0, 0], max = [0.5, 1] }
slip = ")" + slip + "\"\n",
                                "channel"));
}

// At the steady state the plates carry the whole force, and its heat is its power.
TEST(PhysicalViscosity, PlatesCarryTheForce) {
  Simulation simulation(channel("none"));
  while (simulation.running()) simulation.advance();
  std::vector<WallLoad> loads;
  simulation.loads_on_walls(loads);
  double force = 0.0;
  for (WallLoad const& load : loads) force += load.force[0];
  EXPECT_NEAR(force, 0.1 * 1000.0 * 0.5, 1e-3 * 50.0);  // N/m, of 0.5 m^2 of oil
  // Rows that slide past each other press a little along the plates, too.
  simulation.pairs().loads_on_walls(simulation.particles(), simulation.search(), loads);
  for (WallLoad const& load : loads) force -= load.force[0];
  EXPECT_NEAR(force, -simulation.optional_terms().wall_force[0], 1e-9 * force);
  double power = 0.0;
  ParticleStore const& store = simulation.particles();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    power += 0.1 * store.scalar(Field::mass)[i] * store.component(Field::velocity, 0)[i];
  EnergyRates const& heat = simulation.optional_terms().energy;
  EXPECT_NEAR(heat.viscosity + heat.wall_viscosity, power, 1e-3 * power);
  EXPECT_EQ(simulation.vote().reason, end_of_run);
}

TEST(PhysicalViscosity, PlatesWithFreeSlipDoNotDrag) {
  Simulation simulation(channel("free"));
  for (int step = 0; step < 100; ++step) simulation.advance();
  for (double const v : simulation.particles().component(Field::velocity, 0))
    EXPECT_NEAR(v, 0.1 * simulation.time(), 1e-9);
  EXPECT_EQ(simulation.vote().reason, viscous_limit);
}

/// The sum over neighbours, plain.
double summed(Model const& model, std::size_t i, bool volumes) {
  ParticleStore const& store = model.particles;
  auto const mass = store.scalar(Field::mass), rho = store.scalar(Field::density);
  double sum = mass[i] * plain_central_kernel(model, i) / (volumes ? rho[i] : 1.0);
  for (PlainPair const& pair : plain_pairs(model, i))
    sum += mass[pair.j] * pair.kernel / (volumes ? rho[pair.j] : 1.0);
  return sum;
}

TEST(SummedDensity, IsTheSumInEveryStep) {
  for (Precision const precision : {Precision::mixed, Precision::full}) {
    Model model = one_liquid(2);
    model.numerics.precision = precision;
    model.numerics.smoothing.mode = SmoothingMode::density;
    model.numerics.density = DensityForm::summation;
    Simulation simulation(std::move(model));
    for (int step = 0; step < 20; ++step) simulation.advance();
    Model const& now = simulation.model();
    double const share = precision == Precision::mixed ? 2e-6 : 1e-9;
    for (std::size_t i = 0; i < now.particles.range(Kind::fluid).size(); i += 7) {
      double const plain = summed(now, i, false);
      EXPECT_NEAR(now.particles.scalar(Field::density)[i], plain, share * plain);
    }
  }
}

TEST(SummedDensity, NormalisedLacksLessAtFreeSides) {
  Model model = two_blocks(0.0, 0.0);
  model.numerics.density = DensityForm::normalised;
  Simulation const simulation(std::move(model));
  Model plain = two_blocks(0.0, 0.0);
  plain.numerics.density = DensityForm::summation;
  Simulation const without(std::move(plain));
  auto const least = [](Simulation const& run) {
    auto const rho = run.particles().scalar(Field::density);
    return *std::min_element(rho.begin(), rho.end());
  };
  // At a corner the plain sum lacks half of its neighbours, and the volumes lack less than that:
  // those beside it have sums that are too small as well. Measured 665 and 730 of 1000 kg/m^3.
  EXPECT_NEAR(least(without), 665.0, 10.0);
  EXPECT_GT(least(simulation), least(without) + 50.0);
}

TEST(SummedDensity, KeepsTheEnergy) {
  auto const error = [](double time_step) {
    RandomBox box;
    box.scheme = SchemeName::liquid;
    box.velocity = 0.02;
    Model model = random_box(box, 2e-3);
    model.numerics.density = DensityForm::summation;
    model.time.fixed_step = time_step;
    Simulation simulation(std::move(model));
    double const start = simulation.sums().total_energy();
    double moved = 0.0;  // the disorder of the start is under pressure and sets the box in motion
    while (simulation.running()) {
      simulation.advance();
      moved = std::max(moved, simulation.sums().kinetic_energy);
    }
    return std::fabs(simulation.sums().total_energy() - start) / moved;
  };
  double const coarse = error(1e-5), fine = error(5e-6);
  EXPECT_LT(coarse, 1e-2);
  EXPECT_GT(coarse, 3.0 * fine) << coarse << " " << fine;
}

}  // namespace
}  // namespace moraine
