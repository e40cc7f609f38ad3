#include "verify/thrown_block.hpp"

#include <gtest/gtest.h>

#include "setup/build_model.hpp"

namespace moraine {
namespace {

MaterialSpec rubber() {
  Linear law;
  law.reference_density = 1000.0;
  law.reference_sound_speed = 100.0;
  MaterialSpec spec{.name = "rubber", .eos = law};
  spec.strength = {.kind = StrengthKind::elastic, .shear_modulus = 1e6};
  return spec;
}

/// Ten particles of a block at 10 m/s.
Simulation ten() { return Simulation(build_model(thrown_block(rubber(), 10.0, 0.1))); }

double place_of(ParticleStore const& store, std::size_t i) {
  return store.component(Field::position, 0)[i];
}

double falling(ParticleStore const& store, std::size_t i) { return 1.0 - place_of(store, i); }

TEST(ThrownBlock, FliesTowardsItsWall) {
  Simulation const simulation = ten();
  EXPECT_EQ(simulation.particles().range(Kind::fluid).size(), 10u);
  EXPECT_DOUBLE_EQ(mean_of(simulation, velocity_of, 0.0, 1.0), -10.0);
  EXPECT_DOUBLE_EQ(mean_of(simulation, density_of, 0.0, 1.0), 1000.0);
}

TEST(ThrownBlock, MeansAreOfAPart) {
  Simulation const simulation = ten();
  EXPECT_NEAR(mean_of(simulation, place_of, 0.0, 0.5), 0.25, 1e-12);
  EXPECT_NEAR(mean_of(simulation, place_of, 0.5, 0.7), 0.6, 1e-12);
}

TEST(ThrownBlock, CrossingsLieBetweenParticles) {
  Simulation const simulation = ten();
  EXPECT_NEAR(crossing(simulation, falling, 0.37), 0.63, 1e-12);
  EXPECT_EQ(crossing(simulation, place_of, 0.37), 0.0) << "it rises";
}

TEST(ThrownBlock, RunsUntilTheWaveIsThere) {
  Simulation simulation = ten();
  double const half = 0.5 * 1000.0 * 100.0 * 10.0;  // Pa, of the jump without shear
  Passage const first = run_until(simulation, axial_stress, half, 0.2);
  Passage const last = run_until(simulation, axial_stress, half, 0.5);
  EXPECT_GE(first.place, 0.2);
  EXPECT_GE(last.place, 0.5);
  EXPECT_GT(last.time, first.time);
  EXPECT_DOUBLE_EQ(speed_between({1.0, 2.0}, {3.0, 8.0}), 3.0);
  EXPECT_GT(speed_between(first, last), 70.0) << "100 m/s and shear, less the block's own speed";
}

// In one dimension s_xx is compressive behind the wave: the stress exceeds the pressure.
TEST(ThrownBlock, AxialStressHasTheShear) {
  Simulation simulation = ten();
  run_until(simulation, axial_stress, 2.5e5, 0.5);
  double const pressure = mean_of(simulation, pressure_of, 0.0, 0.3);
  EXPECT_GT(mean_of(simulation, axial_stress, 0.0, 0.3), 1.05 * pressure);
  EXPECT_EQ(mean_of(simulation, plastic_work_of, 0.0, 0.3), 0.0) << "elastic";
}

}  // namespace
}  // namespace moraine
