// Programmed burn in a run: when particles are lit, what keeps its order, what is booked and saved.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "exact/detonation.hpp"
#include "output/atomic_file.hpp"
#include "output/checkpoint/hdf5_archive.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "setup/start_particles.hpp"
#include "step/simulation_error.hpp"
#include "support/memory_archive.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

/// A disc of TNT in water, lit at its centre; `more` goes to the end of the file.
std::string disc_in_water(std::string const& burn, std::string const& more = "") {
  return R"(
space = { dimension = 2, domain = { min = [-0.1, -0.1], max = [0.1, 0.1] } }
resolution = { spacing = 0.005, smoothing_factor = 2.0 }
time.end = 20e-6
material.water = { use = "water_shock" }
material.tnt = { use = "tnt", burn = { )" +
         burn + R"( } }
[[region]]
name = "sea"
material = "water"
box = { min = [-0.1, -0.1], max = [0.1, 0.1] }
[[region]]
name = "charge"
material = "tnt"
disc = { center = [0.0, 0.0], radius = 0.04 }
[[wall]]
name = "box"
container = { min = [-0.1, -0.1], max = [0.1, 0.1] }
)" + more;
}

constexpr char const* lit_in_the_middle = "kind = \"programmed\", ignition_points = [[0.0, 0.0]]";

Case disc(std::string const& burn, std::string const& more = "") {
  return parse_case(disc_in_water(burn, more), "case.toml");
}

constexpr MaterialId tnt = 1;

/// Calls f(i) for all particles of the explosive.
template <class F>
void for_explosive(ParticleStore const& store, F&& f) {
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (store.material()[i] == tnt) f(i);
}

std::map<std::uint64_t, double> fractions(ParticleStore const& store) {
  std::map<std::uint64_t, double> found;
  for_explosive(
      store, [&](std::size_t i) { found[store.id()[i]] = store.scalar(Field::burn_fraction)[i]; });
  return found;
}

double burnt(ParticleStore const& store) {
  double sum = 0.0, all = 0.0;
  for_explosive(store, [&](std::size_t i) {
    sum += store.scalar(Field::burn_fraction)[i];
    all += 1.0;
  });
  return sum / all;
}

double radius(ParticleStore const& store, std::size_t i) {
  return std::hypot(store.component(Field::position, 0)[i], store.component(Field::position, 1)[i]);
}

TEST(Burn, BelongsToRunsThatAskForIt) {
  Simulation const plain(build_model(disc("kind = \"instantaneous\"")));
  EXPECT_FALSE(plain.particles().has(Field::burn_fraction));
  EXPECT_TRUE(plain.particles().component(Field::burn_fraction, 0).empty());
  Simulation const burns(build_model(disc(lit_in_the_middle)));
  EXPECT_TRUE(burns.particles().has(Field::burn_fraction));
  EXPECT_EQ(burns.particles().bytes() - plain.particles().bytes(),
            2U * sizeof(double) * burns.particles().range(Kind::fluid).size());
}

TEST(Burn, IsLitWhenTheFrontGetsThere) {
  Simulation const simulation(build_model(disc(std::string(lit_in_the_middle) + ", delay = 2e-6")));
  auto const& store = simulation.particles();
  for_explosive(store, [&](std::size_t i) {
    EXPECT_NEAR(store.scalar(Field::lighting_time)[i], 2e-6 + radius(store, i) / 6930.0, 1e-15);
    EXPECT_EQ(store.scalar(Field::pressure)[i], 0.0) << "nothing burns yet";
  });
}

TEST(Burn, SeesIgnitionAcrossPeriodicSides) {
  Case c = disc("kind = \"programmed\", ignition_points = [[-0.09, 0.0]]");
  c.walls.clear();
  c.periodic = {true, true, false};
  Simulation const simulation(build_model(c));
  auto const& store = simulation.particles();
  for_explosive(store, [&](std::size_t i) {
    double const x = store.component(Field::position, 0)[i];
    double const y = store.component(Field::position, 1)[i];
    double const way = std::min(std::hypot(x + 0.09, y), std::hypot(x - 0.11, y));
    EXPECT_NEAR(store.scalar(Field::lighting_time)[i], way / 6930.0, 1e-15);
  });
}

// A front that is lit in the middle passes a ring at its distance over the speed. Products push
// explosive ahead of it, which burns by compression: not more than the width of the kernel early.
TEST(Burn, TravelsOutwardsAndNeverFalls) {
  Simulation simulation(build_model(disc(lit_in_the_middle)));
  auto before = fractions(simulation.particles());
  auto const& store = simulation.particles();
  double const early = 0.02 / 6930.0;
  while (simulation.time() < 9e-6) {
    simulation.advance();
    for (auto const& [id, fraction] : fractions(store)) {
      ASSERT_GE(fraction, before.at(id));
      ASSERT_LE(fraction, 1.0);
    }
    before = fractions(store);
    for_explosive(store, [&](std::size_t i) {
      double const lit = store.scalar(Field::lighting_time)[i];
      if (simulation.time() > lit + 0.0075 / 6930.0) {
        EXPECT_EQ(store.scalar(Field::burn_fraction)[i], 1.0);
      }
      if (simulation.time() < lit - early) {
        EXPECT_LT(store.scalar(Field::burn_fraction)[i], 0.01);
      }
    });
  }
  EXPECT_EQ(burnt(store), 1.0);
}

// The energy is there from the start: burning books nothing, and the total stays.
TEST(Burn, KeepsTheEnergy) {
  Simulation simulation(build_model(disc(lit_in_the_middle)));
  double const energy = simulation.sums().total_energy();
  while (simulation.running()) simulation.advance();
  EXPECT_EQ(burnt(simulation.particles()), 1.0);
  EXPECT_EQ(simulation.booked().total(), 0.0);
  EXPECT_NEAR(simulation.sums().total_energy(), energy, 0.005 * energy);
}

TEST(Burn, VotesForItsFrontUntilItIsOver) {
  Case c = disc(std::string(lit_in_the_middle) + ", delay = 3e-6");
  double const bound = c.time.courant * c.numerics.smoothing_length() / 6930.0;
  Simulation simulation(build_model(c));
  while (burnt(simulation.particles()) < 1.0) {
    simulation.advance();
    ASSERT_LE(simulation.time_step(), bound * (1.0 + 1e-12));
    if (simulation.time() < 2.9e-6) {
      ASSERT_LT(burnt(simulation.particles()), 1e-3);
    }
  }
  Case never = disc("kind = \"programmed\", ignition_points = [[0.0, 0.0]], delay = 1.0");
  never.regions[1].initial.density = 1629.0;  // not compressed: it has no sound speed of its own
  Simulation waiting(build_model(never));
  waiting.advance();
  EXPECT_EQ(waiting.vote().reason, burn_limit);
}

constexpr char const* wait_then_bang = R"(
[[stage]]
name = "wait"
until = { after = "2 us" }
[[stage]]
name = "bang"
detonate = "charge"
into = "tnt"
)";

TEST(Burn, IsLitByTheStageThatDetonates) {
  Simulation simulation(build_model(disc(lit_in_the_middle, wait_then_bang)));
  auto const& store = simulation.particles();
  while (simulation.stage_events().size() < 2U) {
    for_explosive(store, [&](std::size_t i) {
      ASSERT_TRUE(std::isinf(store.scalar(Field::lighting_time)[i]));
    });
    ASSERT_LT(simulation.time(), 3e-6);
    simulation.advance();
  }
  double const begun = simulation.stage_events()[1].time;
  EXPECT_GE(begun, 2e-6);
  for_explosive(store, [&](std::size_t i) {
    EXPECT_NEAR(store.scalar(Field::lighting_time)[i], begun + radius(store, i) / 6930.0, 1e-9);
  });
  while (simulation.time() < begun + 9e-6) simulation.advance();
  EXPECT_EQ(burnt(store), 1.0);
}

// What was another material before is new explosive: it gets the energy, which is booked.
TEST(Burn, OfATransformedChargeIsBooked) {
  std::string text = disc_in_water(lit_in_the_middle, wait_then_bang);
  text.replace(text.find("material = \"tnt\""), 16, "material = \"wax\"");
  text.insert(text.find("[[region]]"),
              "material.wax = { eos = \"us_up\", reference_density = 1630 }\n");
  Simulation simulation(build_model(parse_case(text, "case.toml")));
  while (simulation.stage_events().size() < 2U) simulation.advance();
  auto const& store = simulation.particles();
  double mass = 0.0;
  for_explosive(store, [&](std::size_t i) { mass += store.scalar(Field::mass)[i]; });
  EXPECT_GT(mass, 7.0);
  EXPECT_NEAR(simulation.booked().detonation, mass * 4.29e6, 1e-3 * mass * 4.29e6);
  EXPECT_LT(burnt(store), 0.1);
  while (burnt(store) < 1.0) {
    ASSERT_LT(simulation.time(), 15e-6);
    simulation.advance();
  }
}

// Explosive that is thrown at a wall burns where it is compressed, though nobody lights it.
TEST(Burn, StartsByCompression) {
  Simulation simulation(build_model(parse_case(R"(
space = { dimension = 1, domain = { min = [-0.02], max = [0.3] } }
resolution = { spacing = 0.0005, smoothing_factor = 2.0 }
numerics = { precision = "double", viscosity_beta = 2.0 }
time.end = 5e-6
material.water = { use = "water_shock" }
material.tnt = { use = "tnt", burn = { kind = "programmed", ignition_points = [[0.0]], delay = 1.0 } }
[[region]]
name = "slug"
material = "tnt"
box = { min = [0.0], max = [0.05] }
velocity = ["-1500 m/s"]
[[wall]]
name = "anvil"
container = { min = [0.0], max = [0.2] }
open = ["x+"]
)",
                                               "case.toml")));
  auto const& store = simulation.particles();
  double const energy = simulation.sums().total_energy();
  while (simulation.running()) simulation.advance();
  auto const part = [&](double from, double to) {
    double least = 1.0, most = 0.0;
    for_explosive(store, [&](std::size_t i) {
      double const x = store.component(Field::position, 0)[i];
      if (x < from || x > to) return;
      least = std::min(least, store.scalar(Field::burn_fraction)[i]);
      most = std::max(most, store.scalar(Field::burn_fraction)[i]);
    });
    return std::pair(least, most);
  };
  EXPECT_GT(part(0.0, 0.01).first, 0.5) << "burns at the anvil";
  EXPECT_LT(part(0.04, 0.05).second, 1e-5) << "no wave has come so far";
  EXPECT_NEAR(simulation.sums().total_energy(), energy, 0.01 * energy);
}

TEST(Burn, GoesOnWithTheSameBits) {
  Case c = disc(lit_in_the_middle);
  c.time.end = 1e-3;
  Simulation straight(build_model(c));
  while (burnt(straight.particles()) < 0.5) straight.advance();
  auto const path =
      std::filesystem::temp_directory_path() / ("moraine_burn_" + std::to_string(getpid()) + ".h5");
  with_hdf5_image([&](Archive& archive) { straight.save(archive); },
                  [&](FileImage image) { write_file(path, image); });
  std::unique_ptr<Simulation> resumed;
  restore_hdf5(path, [&](Archive& archive) {
    resumed = std::make_unique<Simulation>(build_model(c), archive);
  });
  std::filesystem::remove(path);
  EXPECT_TRUE(state_by_id(resumed->particles()) == state_by_id(straight.particles()));
  for (int step = 0; step < 60; ++step) {
    straight.advance();
    resumed->advance();
  }
  EXPECT_TRUE(state_by_id(resumed->particles()) == state_by_id(straight.particles()));
  EXPECT_GT(burnt(straight.particles()), 0.6);
}

TEST(Burn, DoesNotGoOnFromAStateThatDoesNotBurn) {
  Simulation plain(build_model(disc("kind = \"instantaneous\"")));
  MemoryArchive archive;
  plain.save(archive);
  archive.restore();
  EXPECT_THROW(Simulation(build_model(disc(lit_in_the_middle)), archive), std::runtime_error);
}

// A case that starts from a run in which the charge was burning: its front goes on.
TEST(Burn, GoesOnInACaseThatStartsFromIt) {
  Case c = disc(lit_in_the_middle);
  Simulation first(build_model(c));
  while (burnt(first.particles()) < 0.5) first.advance();
  Case next = c;
  next.regions.clear();
  next.start.run = "first";
  next.start.particles = std::make_shared<ParticleStore>(first.particles());
  next.start.info.time = first.time();
  next.start.info.dimension = 2;
  next.start.info.spacing = next.start.info.finest_spacing = c.numerics.spacing;
  next.start.info.materials = {{"water", ""}, {"tnt", ""}};
  Simulation second(build_model(next));
  EXPECT_NEAR(burnt(second.particles()), burnt(first.particles()), 0.02);
  auto const& store = second.particles();
  for_explosive(store, [&](std::size_t i) {
    EXPECT_LT(store.scalar(Field::lighting_time)[i], 0.045 / 6930.0 - first.time());
  });
  while (burnt(store) < 1.0) {
    ASSERT_LT(second.time(), 6e-6);
    second.advance();
  }
}

// Products that are an ideal gas: plane detonation from a plane of symmetry, against its Taylor
// wave. Eight tenths of the zone at rest, with 3 % for the smeared waves around it.
TEST(Burn, RunsInAnIdealGas) {
  Case const c = parse_case(R"(
space = { dimension = 1, domain = { min = [0.0], max = [0.3] }, symmetry = ["x-"] }
resolution = { spacing = 0.0002, smoothing_factor = 3.0 }
numerics = { precision = "double", viscosity_beta = 2.0 }
time.end = 13e-6
[material.gas]
eos = "ideal_gas"
reference_density = 1630
heat_capacity_ratio = 2.7
reference_energy = 4.0e6
burn = { kind = "programmed", ignition_points = [[0.0]] }
[[region]]
name = "slab"
material = "gas"
box = { min = [0.0], max = [0.1] }
)",
                            "case.toml");
  TaylorWave const exact(Explosive{c.materials[0].eos, 1630.0, 4.0e6});
  Simulation simulation(build_model(c));
  while (simulation.running()) simulation.advance();
  auto const& store = simulation.particles();
  double sum = 0.0, count = 0.0, front = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    double const p = store.scalar(Field::pressure)[i];
    if (p > 0.5 * exact.detonation().behind.pressure) front = std::max(front, x);
    if (x > 0.8 * exact.rest_speed() * simulation.time()) continue;
    sum += p;
    count += 1.0;
  }
  EXPECT_NEAR(sum / count, exact.rest().pressure, 0.03 * exact.rest().pressure);
  EXPECT_NEAR(front, exact.detonation().speed * simulation.time(), 0.001);
}

// The charge stands alone in space: nothing but its front gives guards a speed to compare with.
TEST(Burn, GuardsKnowTheFront) {
  std::string text = disc_in_water(lit_in_the_middle);
  auto const sea = text.find("[[region]]");
  text.erase(sea, text.find("[[region]]", sea + 1) - sea);
  Simulation simulation(build_model(parse_case(text, "case.toml")));
  while (simulation.time() < 12e-6) simulation.advance();
  EXPECT_EQ(burnt(simulation.particles()), 1.0);
  auto const& parts = simulation.guards().largest_parts();
  for (Guard const guard : {Guard::speed, Guard::energy, Guard::budget})
    EXPECT_LT(parts[static_cast<std::size_t>(guard)], 0.5) << info(guard).name;
  EXPECT_GT(parts[static_cast<std::size_t>(Guard::speed)], 0.01);
}

// A state that no shock reaches stops the run with the name of the particle and of the limit.
TEST(Matter, GuardNamesTheLimitOfAShockLine) {
  Case c = parse_case(R"(
space = { dimension = 1, domain = { min = [-0.1], max = [1.1] } }
resolution.spacing = 0.05
time.end = 1.0
material.water = { use = "water_us_up" }
[[region]]
name = "pool"
material = "water"
box = { min = [0.0], max = [1.0] }
)",
                      "case.toml");
  Model model = build_model(c);
  model.particles.scalar(Field::density)[3] = 2400.0;
  try {
    Simulation const simulation(std::move(model));
    ADD_FAILURE() << "no error";
  } catch (SimulationError const& error) {
    std::string const text = error.what();
    EXPECT_NE(text.find("particle 3 (water)"), std::string::npos) << text;
    EXPECT_NE(text.find("no sound speed (c^2 < 0) at density 2400 kg/m^3"), std::string::npos)
        << text;
    EXPECT_NE(text.find("no shock reaches the density 2328.67 kg/m^3"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace moraine
