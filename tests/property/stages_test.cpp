// Stages: settle with damping, release a gate, detonate; when they end, and across a checkpoint.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "base/input_error.hpp"
#include "output/atomic_file.hpp"
#include "output/checkpoint/hdf5_archive.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

/// Water without pressure behind a gate, which settles, is released, and ends under a shock.
std::string three_stages() {
  return R"(
space = { dimension = 2, domain = { min = [-0.2, -0.2], max = [1.2, 1.0] } }
physics.gravity = [0.0, -9.81]
resolution = { spacing = 0.02, smoothing_factor = 1.5 }
time.end = 10.0
material.water = { eos = "tait", reference_sound_speed = 25.0 }
[[region]]
name = "column"
material = "water"
box = { min = [0.0, 0.0], max = [0.4, 0.4] }
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [1.0, 0.8] }
open = ["y+"]
[[wall]]
name = "gate"
solid = { min = [0.4, 0.0], max = [0.48, 0.6] }
[[gauge]]
name = "beyond"
position = [0.7, 0.03]
[[stage]]
name = "settle"
damping_time = 0.05
until = { rms_speed_below = 0.005, steady_for = 0.1, after = 5.0 }
[[stage]]
name = "release"
remove_wall = "gate"
until = { gauge = "beyond", pressure_above = 50.0 }
[[stage]]
name = "flow"
)";
}

double farthest(Simulation const& simulation) {
  double most = 0.0;
  auto const& store = simulation.particles();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    most = std::max(most, store.component(Field::position, 0)[i]);
  return most;
}

void advance_to_stage(Simulation& simulation, std::size_t stages) {
  for (int step = 0; step < 20000 && simulation.stage_events().size() < stages; ++step)
    simulation.advance();
}

TEST(Stages, SettleThenReleaseThenGoOnWhenAGaugeSaysSo) {
  Simulation simulation(build_model(parse_case(three_stages(), "case.toml")));
  std::size_t const walls = simulation.particles().range(Kind::wall).size();
  advance_to_stage(simulation, 2);
  ASSERT_EQ(simulation.stage_events().size(), 2U);
  EXPECT_EQ(simulation.stage_events()[1].stage, "release");
  EXPECT_NE(simulation.stage_events()[1].cause.find("root-mean-square speed"), std::string::npos)
      << "and not because 5 s were over: " << simulation.stage_events()[1].cause;
  ConservedSums const settled = simulation.sums();
  EXPECT_LT(std::sqrt(2.0 * settled.kinetic_energy / settled.mass), 0.006);
  EXPECT_LT(farthest(simulation), 0.4) << "held back by the gate until then";
  EXPECT_LT(simulation.particles().range(Kind::wall).size(), walls) << "the gate is gone";
  advance_to_stage(simulation, 3);
  ASSERT_EQ(simulation.stage_events().size(), 3U);
  EXPECT_NE(simulation.stage_events()[2].cause.find("is above 50 Pa"), std::string::npos);
  EXPECT_GT(farthest(simulation), 0.65) << "the water has reached the gauge";
  // Without pressure and under gravity a front moves slower than 2 sqrt(g H).
  double const flown = simulation.time() - simulation.stage_events()[1].time;
  EXPECT_GT(flown, (0.65 - 0.4) / (2.0 * std::sqrt(9.81 * 0.4)));
}

// Damping alone: all velocities fall as exp(-t / T), exactly so for water that nothing pushes.
TEST(Stages, DampingHasItsTime) {
  Case c = parse_case(R"(
space = { dimension = 1, domain = { min = [-1.0], max = [3.0] } }
resolution.spacing = 0.1
time = { end = 0.2, fixed_step = 1e-4 }
material.water = { eos = "tait", reference_sound_speed = 10.0 }
[[region]]
name = "slug"
material = "water"
box = { min = [0.0], max = [1.0] }
velocity = [2.0]
[[stage]]
name = "damped"
damping_time = 0.1
)",
                      "case.toml");
  Simulation simulation(build_model(c));
  while (simulation.running()) simulation.advance();
  // v falls to e^-2; the kick from the half step adds an error of the first order, dt / (2 T).
  for (double const v : simulation.particles().component(Field::velocity, 0).first(10))
    EXPECT_NEAR(v, 2.0 * std::exp(-2.0), 2.0 * std::exp(-2.0) * 2e-3);
}

TEST(Stages, AChargeDetonatesWhenItsTimeHasCome) {
  Case c = parse_case(R"(
space.dimension = 1
space.domain = { min = [-0.1], max = [1.1] }
resolution = { spacing = 0.01, smoothing_factor = 2.0 }
time.end = 60e-6
material.water = { eos = "water_polynomial" }
material.casing = { eos = "tait", reference_density = 1630.0, reference_sound_speed = 2000.0 }
material.tnt = { eos = "jwl" }
[[region]]
name = "water"
material = "water"
box = { min = [0.0], max = [1.0] }
[[region]]
name = "charge"
material = "casing"
box = { min = [0.0], max = [0.1] }
[[wall]]
name = "ends"
container = { min = [0.0], max = [1.0] }
[[stage]]
name = "wait"
until = { after = "20 us" }
[[stage]]
name = "bang"
detonate = "charge"
into = "tnt"
)",
                      "case.toml");
  Simulation simulation(build_model(c));
  double const quiet = simulation.sums().internal_energy;
  while (simulation.time() < 18e-6) simulation.advance();
  // The water's reference state has one atmosphere, the casing's none: 1e5 / (rho c) = 0.07 m/s.
  EXPECT_LT(largest(simulation.particles(), Field::velocity, 0), 0.07) << "nothing else moves";
  advance_to_stage(simulation, 2);
  ASSERT_EQ(simulation.stage_events().size(), 2U);
  EXPECT_GE(simulation.stage_events()[1].time, 20e-6);
  // Ten cells of 1630 kg/m^3 get the energy of the explosive.
  double const energy = reference_energy(c.materials[2].eos);
  EXPECT_NEAR(simulation.sums().internal_energy - quiet, 1630.0 * 0.1 * energy,
              1e-3 * 163.0 * energy);
  while (simulation.running()) simulation.advance();
  EXPECT_GT(largest(simulation.particles(), Field::velocity, 0), 100.0);
}

TEST(Stages, GiveTheSameBitsAcrossACheckpoint) {
  Case const c = parse_case(three_stages(), "case.toml");
  Simulation straight(build_model(c));
  advance_to_stage(straight, 2);
  for (int step = 0; step < 7; ++step) straight.advance();
  auto const path = std::filesystem::temp_directory_path() /
                    ("moraine_stages_" + std::to_string(getpid()) + ".h5");
  with_hdf5_image([&](Archive& archive) { straight.save(archive); },
                  [&](FileImage image) { write_file(path, image); });
  std::unique_ptr<Simulation> resumed;
  restore_hdf5(path, [&](Archive& archive) {
    resumed = std::make_unique<Simulation>(build_model(c), archive);
  });
  std::filesystem::remove(path);
  advance_to_stage(straight, 3);
  advance_to_stage(*resumed, 3);
  ASSERT_EQ(resumed->stage_events().size(), 3U);
  EXPECT_EQ(resumed->stage_events()[1].cause, straight.stage_events()[1].cause);
  EXPECT_EQ(resumed->step(), straight.step());
  EXPECT_TRUE(state_by_id(resumed->particles()) == state_by_id(straight.particles()));
}

TEST(Stages, AreInTheUsedCase) {
  Case const c = parse_case(three_stages(), "case.toml");
  std::string const text = used_case(c);
  EXPECT_NE(text.find("remove_wall = \"gate\""), std::string::npos) << text;
  EXPECT_EQ(used_case(parse_case(text, "used.toml")), text);
}

TEST(Stages, MistakesAreNamed) {
  auto const message = [](std::string const& stages) {
    std::string text = three_stages();
    text.erase(text.find("[[stage]]"));
    try {
      parse_case(text + stages, "case.toml");
    } catch (InputErrors const& errors) {
      return std::string(errors.what());
    }
    return std::string();
  };
  auto const expect = [&](std::string const& stages, std::string const& part) {
    EXPECT_NE(message(stages).find(part), std::string::npos) << message(stages);
  };
  expect("[[stage]]\nname = \"a\"\nremove_wall = \"gte\"\n", "is not a wall of this case");
  expect("[[stage]]\nname = \"a\"\nremove_wall = \"gte\"\n", "did you mean \"gate\"");
  expect("[[stage]]\nname = \"a\"\ndetonate = \"column\"\n", "needs into beside it");
  expect("[[stage]]\nname = \"a\"\nuntil.rms_speed_below = 1.0\n", "needs until.steady_for");
  expect("[[stage]]\nname = \"a\"\nuntil.after = 1.0\n", "has no effect: no stage follows");
  expect("[[stage]]\nname = \"a\"\n[[stage]]\nname = \"b\"\n", "that others follow must end");
  expect("[[stage]]\nname = \"a\"\nuntil = { gauge = \"beyond\" }\n", "needs until.pressure_above");
  expect("[[stage]]\nname = \"a\"\ndamping_time = \"5 m\"\n", "a time is expected");
}

}  // namespace
}  // namespace moraine
