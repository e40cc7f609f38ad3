// Smoothing lengths that follow the density.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation.hpp"
#include "verify/random_box.hpp"

namespace moraine {
namespace {

/// A square block of cold gas in free expansion, v = x / (1 s): after t it is 1 + t times as wide.
Simulation expanding_block(std::string const& smoothing) {
  Model model = build_model(parse_case(R"(
space.dimension = 2
space.domain = { min = [-4, -4], max = [4, 4] }
resolution = { spacing = 0.05, smoothing_factor = 1.5, smoothing = )" +
                                           smoothing + R"( }
numerics = { precision = "double", continuity = "volume", viscosity_alpha = 0, viscosity_beta = 0 }
time = { end = 1, fixed_step = 2e-3 }
[material.gas]
eos = "ideal_gas"
reference_density = 1
reference_energy = 1e-9
[[region]]
name = "block"
material = "gas"
box = { min = [-1, -1], max = [1, 1] }
)",
                                       "block"));
  ParticleStore& store = model.particles;
  for (int axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
      store.component(Field::velocity, axis)[i] = store.component(Field::position, axis)[i];
  return Simulation(std::move(model));
}

double neighbours(Simulation const& simulation) {
  return static_cast<double>(simulation.pairs().count_pairs(simulation.search())) /
         static_cast<double>(simulation.particles().range(Kind::fluid).size());
}

class FreeExpansion : public testing::TestWithParam<char const*> {};

TEST_P(FreeExpansion, KeepsTheNeighbours) {
  Simulation simulation = expanding_block(std::string("{ mode = \"") + GetParam() + "\" }");
  double const before = neighbours(simulation);
  double const h_before = simulation.particles().scalar(Field::smoothing_length)[0];
  EXPECT_NEAR(h_before, 0.075, 1e-12);
  while (simulation.running()) simulation.advance();
  ParticleStore const& store = simulation.particles();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const h = store.scalar(Field::smoothing_length)[i];
    double const rho = store.scalar(Field::density)[i];
    // h^d rho stays: by density up to the error of the predicted density, by its rate to the first
    // order of the time step, 0.002 of the expansion; measured 3e-6 and 2.1e-3.
    double const drift = std::string(GetParam()) == "density" ? 1e-5 : 4e-3;
    EXPECT_NEAR(h * h * rho, 0.075 * 0.075, drift * 0.075 * 0.075) << i;
    double const x = store.component(Field::position, 0)[i];
    double const y = store.component(Field::position, 1)[i];
    // Inside, the density of the exact expansion: the kernel's sum over a lattice is that good.
    if (std::max(std::fabs(x), std::fabs(y)) < 1.4) {
      EXPECT_NEAR(h, 0.15, 0.01 * 0.15) << x << " " << y;
    }
  }
  // Edge particles, whose density lags, lose some: 8 % of all, against 70 % with a constant length.
  EXPECT_NEAR(neighbours(simulation), before, 0.1 * before);
  EXPECT_EQ(simulation.smoothing_clips().at_most, 0u);
}

INSTANTIATE_TEST_SUITE_P(Modes, FreeExpansion, testing::Values("rate", "density"));

TEST(VariableSmoothing, ConstantLengthLosesTheNeighbours) {
  Simulation simulation = expanding_block("{ mode = \"constant\" }");
  double const before = neighbours(simulation);
  while (simulation.running()) simulation.advance();
  EXPECT_LT(neighbours(simulation), 0.4 * before);
}

TEST(VariableSmoothing, IsCutOffAndSaysSo) {
  Simulation simulation = expanding_block("{ mode = \"density\", most = 1.2 }");
  while (simulation.running()) simulation.advance();
  double largest = 0.0;
  for (double const h : simulation.particles().scalar(Field::smoothing_length))
    largest = std::max(largest, h);
  EXPECT_DOUBLE_EQ(largest, 1.2 * 0.075);
  EXPECT_GT(simulation.smoothing_clips().at_most, 1000u);
  EXPECT_EQ(simulation.smoothing_clips().at_least, 0u);
}

/// Change of the total energy of a disordered box, by its kinetic energy.
double energy_error(SmoothingMode mode, double time_step) {
  RandomBox box;
  box.velocity = 0.02;
  Model model = random_box(box, 2e-3);
  model.numerics.smoothing.mode = mode;
  model.time.fixed_step = time_step;
  Simulation simulation(std::move(model));
  ConservedSums const start = simulation.sums();
  while (simulation.running()) simulation.advance();
  return std::fabs(simulation.sums().total_energy() - start.total_energy()) / start.kinetic_energy;
}

// A pair has one h: momentum and energy are conserved whatever it is, energy to the order of the
// time step squared.
TEST(VariableSmoothing, ConservesEnergyToSecondOrder) {
  for (SmoothingMode const mode : {SmoothingMode::rate, SmoothingMode::density}) {
    double const coarse = energy_error(mode, 1e-5);
    double const fine = energy_error(mode, 5e-6);
    EXPECT_LT(coarse, 2e-3);
    EXPECT_GT(coarse, 3.0 * fine) << coarse << " " << fine;
  }
}

// The wall's lattice is five times as coarse as the water's: its support must not be that of the
// water, which would find holes in it.
TEST(VariableSmoothing, FineWaterStaysInACoarseTank) {
  Simulation simulation(build_model(parse_case(R"(
space.dimension = 2
space.domain = { min = [-1, -1], max = [1, 1] }
resolution = { spacing = 0.05, smoothing_factor = 1.2, smoothing = { mode = "density", least = 0.1 } }
numerics = { viscosity_alpha = 0.1, viscosity_beta = 0 }
physics.gravity = [0, -9.81]
time.end = 0.3
[material.water]
eos = "tait"
reference_sound_speed = 40
[[region]]
name = "column"
material = "water"
spacing = 0.01
box = { min = [-0.5, -0.5], max = [-0.2, -0.1] }
[[wall]]
name = "tank"
container = { min = [-0.5, -0.5], max = [0.5, 0.5] }
open = ["y+"]
)",
                                               "tank")));
  while (simulation.running()) simulation.advance();
  ParticleStore const& store = simulation.particles();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    EXPECT_NEAR(store.scalar(Field::smoothing_length)[i], 0.012, 0.001);
    EXPECT_GT(store.component(Field::position, 0)[i], -0.5) << i;
    EXPECT_GT(store.component(Field::position, 1)[i], -0.5) << i;
  }
  EXPECT_EQ(simulation.lost().count, 0u);
}

}  // namespace
}  // namespace moraine
