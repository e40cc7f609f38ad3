// The guards that look every few steps: each stops a run that was made to fail its way, names and
// flags who is guilty and nobody else, and leaves sound runs alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation_error.hpp"
#include "support/memory_archive.hpp"
#include "support/places.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

constexpr std::size_t guilty = 6;

/// Sixteen particles of one liquid (1000 kg/m^3, 100 m/s), ten spacings apart: out of reach of
/// each other, so that what is done to one stays with it.
Model scattered(double velocity = 0.0) {
  RandomBox box;
  box.side = 4;
  box.scheme = SchemeName::liquid;
  box.displacement = 0.0;
  box.velocity = velocity;
  Model model = random_box(box, 1.0);
  model.periodic = {};
  model.domain_min = {-1.0, -1.0, 0.0};
  model.domain_max = {1.0, 1.0, 0.0};
  for (int axis = 0; axis < 2; ++axis)
    for (double& x : model.particles.component(Field::position, axis)) x *= 10.0;
  for (double& density : model.particles.scalar(Field::density)) density = 1000.0;
  model.guards.interval = 1;
  return model;
}

void leave_on(Model& model, Guard guard) {
  for (GuardInfo const& other : guard_table)
    if (other.optional && other.guard != guard) model.guards.off.push_back(std::string(other.name));
}

/// A run of ten steps in which one number of the guilty one is then changed.
std::unique_ptr<Simulation> tampered(Model const& model, std::string const& piece, double value) {
  Simulation before(model);
  for (int step = 0; step < 10; ++step) before.advance();
  auto const id = before.particles().id();
  auto const at = std::find(id.begin(), id.end(), guilty) - id.begin();
  MemoryArchive archive;
  before.save(archive);
  archive.piece<std::vector<double>>(piece)[static_cast<std::size_t>(at)] = value;
  archive.restore();
  return std::make_unique<Simulation>(model, archive);
}

std::optional<SimulationError> error_in(Simulation& simulation, int steps) {
  try {
    for (int step = 0; step < steps; ++step) simulation.advance();
  } catch (SimulationError const& error) {
    return error;
  }
  return std::nullopt;
}

void expect_guilty(std::optional<SimulationError> const& error, Guard guard,
                   std::string const& cause) {
  ASSERT_TRUE(error.has_value()) << info(guard).name;
  std::string const text = error->what();
  EXPECT_EQ(text.find("unstable: particle 6 (light) at ("), 0U) << text;
  for (std::string const& part :
       {cause, "\n  guard: " + std::string(info(guard).name), std::string("limited by sound"),
        std::string("\n  last time steps: ")})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  ASSERT_EQ(error->flags().size(), 1U) << text;
  EXPECT_EQ(error->flags()[0].particle, guilty);
  EXPECT_EQ(error->flags()[0].guard, flag_of(guard));
}

struct Injury {
  Guard guard;
  char const* piece;
  double harmless, harmful;  // just inside and just outside of the bound
  char const* cause;
};

void PrintTo(Injury const& injury, std::ostream* stream) {
  *stream << info(injury.guard).name << ' ' << injury.harmful;
}

class InjuredRun : public testing::TestWithParam<Injury> {};

TEST_P(InjuredRun, IsStoppedOutsideOfTheBoundOnly) {
  Injury const& injury = GetParam();
  Model model = scattered();
  model.guards.speed = 4.0;  // 400 m/s: faster ones would meet the guard of motion in their step
  leave_on(model, injury.guard);
  EXPECT_FALSE(error_in(*tampered(model, injury.piece, injury.harmless), 3).has_value());
  expect_guilty(error_in(*tampered(model, injury.piece, injury.harmful), 1), injury.guard,
                injury.cause);
  model.guards.off.push_back(std::string(info(injury.guard).name));
  EXPECT_FALSE(error_in(*tampered(model, injury.piece, injury.harmful), 3).has_value()) << "off";
}

// Density: 3 times 1000 kg/m^3; a thousandth of 1000 / 2.4^2 in two dimensions. Speed: 4 times the
// sound speed. Energy: ten times half the square of the sound speed, 5e4 J/kg.
INSTANTIATE_TEST_SUITE_P(
    All, InjuredRun,
    testing::Values(Injury{Guard::density, "particles/density", 2990.0, 3010.0,
                           "is above 3000 kg/m^3 (guards.compression)"},
                    Injury{Guard::density, "particles/density", 0.175, 0.173,
                           "is below 0.173611 kg/m^3 (guards.expansion)"},
                    Injury{Guard::speed, "particles/velocity_x", 399.0, 401.0,
                           "its speed 401 m/s is above 400 m/s (guards.speed)"},
                    Injury{Guard::energy, "particles/specific_energy", 4.99e4, 5.01e4,
                           "is above 5e+04 J/kg (guards.specific_energy)"},
                    Injury{Guard::energy, "particles/specific_energy", -4.99e4, -5.01e4,
                           "is below -5e+04 J/kg (guards.specific_energy)"}));

TEST(OptionalGuards, LookAtMultiplesOfTheInterval) {
  Model model = scattered();
  model.guards.interval = 7;
  auto const run = tampered(model, "particles/density", 5000.0);  // after ten steps
  EXPECT_FALSE(error_in(*run, 4).has_value());
  EXPECT_TRUE(error_in(*run, 1).has_value()) << "the step that follows the fourteenth";
  auto const other = tampered(model, "particles/density", 5000.0);
  EXPECT_THROW(other->check(), SimulationError) << "asked to look before a state is kept";
}

TEST(OptionalGuards, FlagAllAndTellTheWorstFirst) {
  Model model = scattered();
  Simulation before(model);
  MemoryArchive archive;
  before.save(archive);
  auto& density = archive.piece<std::vector<double>>("particles/density");
  std::vector<std::uint64_t> bad;
  for (std::size_t i = 0; i < 8; ++i) {
    density[i] = i == 3 ? 5000.0 : 4000.0;
    bad.push_back(before.particles().id()[i]);
  }
  std::sort(bad.begin(), bad.end());
  archive.restore();
  Simulation run(model, archive);
  auto const error = error_in(run, 1);
  ASSERT_TRUE(error.has_value());
  std::string const text = error->what();
  std::string const worst =
      "unstable: particle " + std::to_string(before.particles().id()[3]) + " (light)";
  EXPECT_EQ(text.find(worst), 0U) << text;
  EXPECT_NE(text.find("\n  also particle "), std::string::npos) << text;
  EXPECT_NE(text.find("\n  and 3 more"), std::string::npos) << text;
  ASSERT_EQ(error->flags().size(), bad.size());
  for (std::size_t k = 0; k < bad.size(); ++k) EXPECT_EQ(error->flags()[k].particle, bad[k]);
}

TEST(OptionalGuards, FlagAllWhoseStateIsNoNumber) {
  Model model = scattered();
  for (std::size_t const i : {6U, 7U, 11U})
    model.particles.scalar(Field::specific_energy)[i] = std::nan("");
  try {
    Simulation const simulation(model);
    FAIL() << "not stopped";
  } catch (SimulationError const& error) {
    ASSERT_EQ(error.flags().size(), 3U) << error.what();
    EXPECT_EQ(error.flags()[0].particle, 6U);
    EXPECT_EQ(error.flags()[2].particle, 11U);
    EXPECT_EQ(error.flags()[2].guard, flag_of(Guard::finite));
  }
}

// A kick that no single bound objects to, but the sum of energies does: one of 16 particles of
// 0.1 kg gets more heat than a twentieth of what all of them have.
TEST(OptionalGuards, MissEnergyThatNobodyBooked) {
  Model model = scattered(0.05);
  Simulation const start(model);
  double const all = start.sums().kinetic_energy;
  ASSERT_GT(all, 0.0);
  double const mass = model.particles.scalar(Field::mass)[guilty];
  // The kick itself belongs to the energy of the run by then.
  double const bound = 0.05 * all / 0.95;
  EXPECT_FALSE(
      error_in(*tampered(model, "particles/specific_energy", 0.99 * bound / mass), 3).has_value());
  // The most energetic one is meant, and for a kick that large that is the one with the kick.
  expect_guilty(error_in(*tampered(model, "particles/specific_energy", 5.0 * all / mass), 1),
                Guard::budget, "that nothing accounts for");
  auto const small =
      error_in(*tampered(model, "particles/specific_energy", 1.01 * bound / mass), 1);
  ASSERT_TRUE(small.has_value());
  EXPECT_EQ(small->flags()[0].guard, flag_of(Guard::budget));
}

// A sound speed of 15^3 times that of the start, for as many steps as the interval.
TEST(OptionalGuards, StopARunThatMakesShortStepsOnly) {
  Model model = scattered();
  model.guards.interval = 12;
  leave_on(model, Guard::collapse);
  auto const run = tampered(model, "particles/density", 15000.0);
  // The first step is still that of the old sound speed.
  EXPECT_FALSE(error_in(*run, 12).has_value());
  expect_guilty(error_in(*run, 1), Guard::collapse, "for 12 steps the time step has been below");
}

TEST(OptionalGuards, DoNotTakeAShortFixedStepForACollapse) {
  Model model = scattered();
  model.time.fixed_step = 1e-12;
  Simulation simulation(model);
  EXPECT_FALSE(error_in(simulation, 20).has_value());
}

TEST(OptionalGuards, RememberAcrossACheckpoint) {
  Model model = scattered();
  model.guards.interval = 12;
  leave_on(model, Guard::collapse);
  auto const straight = tampered(model, "particles/density", 15000.0);
  for (int step = 0; step < 6; ++step) straight->advance();
  MemoryArchive archive;
  straight->save(archive);
  archive.restore();
  Simulation resumed(model, archive);
  auto const expected = error_in(*straight, 10);
  auto const found = error_in(resumed, 10);
  ASSERT_TRUE(expected.has_value() && found.has_value());
  EXPECT_STREQ(found->what(), expected->what());
  EXPECT_EQ(resumed.step(), straight->step());
}

TEST(OptionalGuards, ChangeNoBit) {
  auto const state = [](bool guarded) {
    Model model = small_dam_break(2, Precision::mixed, 10.0);
    model.guards.interval = 1;
    if (!guarded)
      for (GuardInfo const& guard : guard_table)
        model.guards.off.push_back(std::string(guard.name));
    Simulation simulation(std::move(model));
    for (int step = 0; step < 200; ++step) {
      simulation.advance();
      if (guarded) simulation.check();
    }
    return state_by_id(simulation.particles());
  };
  EXPECT_TRUE(state(true) == state(false));
}

std::vector<std::string> shipped() {
  std::vector<std::string> files;
  for (char const* const folder : {"cases", "starters"})
    for (auto const& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(source_folder()) / folder))
      if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() != "sweeps")
        files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

class ShippedCase : public testing::TestWithParam<std::string> {};

// No bound is near in a sound run; largest parts seen in whole runs: docs/guards.md.
TEST_P(ShippedCase, MeetsNoGuard) {
  Model model = build_model(read_case(GetParam()));
  model.guards.interval = 5;
  bool const large = model.particles.size() > 10000;
  Simulation simulation(std::move(model));
  for (int step = 0; step < (large ? 40 : 200) && simulation.running(); ++step)
    ASSERT_NO_THROW(simulation.advance());
  for (GuardInfo const& guard : guard_table) {
    if (!guard.optional) continue;
    EXPECT_LT(simulation.guards().largest_parts()[static_cast<std::size_t>(guard.guard)], 0.5)
        << guard.name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedCase, testing::ValuesIn(shipped()), [](auto const& test) {
  std::filesystem::path const file = test.param;
  std::string name = (file.stem() == "case" ? file.parent_path() : file).stem().string();
  name += file.stem() == "case" ? "_case" : "_starter";
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// What leaves through open sides is counted and no reason to stop.
TEST(OptionalGuards, LetEjectaLeave) {
  RandomBox box;
  box.side = 24;
  box.velocity = 0.3;
  Model model = random_box(box, 10.0);
  model.periodic[0] = false;
  model.guards.interval = 1;
  Simulation simulation(std::move(model));
  EXPECT_FALSE(error_in(simulation, 200).has_value());
  EXPECT_GT(simulation.lost().count, 10U);
}

}  // namespace
}  // namespace moraine
