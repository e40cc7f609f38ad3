// Porous compaction in a run: what particles remember, what is saved, and what a start takes over.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "output/atomic_file.hpp"
#include "output/checkpoint/hdf5_archive.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "setup/start_particles.hpp"
#include "setup/used_case.hpp"
#include "support/memory_archive.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

constexpr char const* sand_keys = "use = \"dry_sand\"";

/// A charge, burnt at once, on a bed of sand; `more` goes to the end of the file.
std::string charge_on_sand(std::string const& sand = sand_keys, std::string const& more = "") {
  return R"(
space = { dimension = 2, domain = { min = [-0.2, -0.2], max = [0.2, 0.2] } }
resolution = { spacing = 0.01, smoothing_factor = 1.5 }
time.end = 200e-6
material.sand = { )" +
         sand + R"( }
material.tnt = { use = "tnt" }
[[region]]
name = "bed"
material = "sand"
box = { min = [-0.2, -0.2], max = [0.2, 0.0] }
[[region]]
name = "charge"
material = "tnt"
box = { min = [-0.03, 0.0], max = [0.03, 0.06] }
[[wall]]
name = "box"
container = { min = [-0.2, -0.2], max = [0.2, 0.2] }
open = ["y+"]
)" + more;
}

Case bed(std::string const& sand = sand_keys, std::string const& more = "") {
  return parse_case(charge_on_sand(sand, more), "case.toml");
}

constexpr MaterialId sand = 0, tnt = 1;

template <class F>
void for_material(ParticleStore const& store, MaterialId material, F&& f) {
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (store.material()[i] == material) f(i);
}

std::map<std::uint64_t, double> distensions(ParticleStore const& store) {
  std::map<std::uint64_t, double> found;
  for_material(store, sand,
               [&](std::size_t i) { found[store.id()[i]] = store.scalar(Field::distension)[i]; });
  return found;
}

double least(std::map<std::uint64_t, double> const& of) {
  return std::min_element(of.begin(), of.end(),
                          [](auto const& a, auto const& b) { return a.second < b.second; })
      ->second;
}

TEST(Compaction, BelongsToRunsWithPores) {
  Simulation const porous(build_model(bed()));
  EXPECT_TRUE(porous.particles().has(Field::distension));
  Simulation const solid(build_model(bed("eos = \"us_up\", reference_density = 2650")));
  EXPECT_FALSE(solid.particles().has(Field::distension));
  auto const& store = porous.particles();
  for_material(store, tnt, [&](std::size_t i) {
    EXPECT_EQ(store.scalar(Field::distension)[i], 1.0) << "no pores";
  });
  for_material(store, sand, [&](std::size_t i) {
    EXPECT_DOUBLE_EQ(store.scalar(Field::distension)[i], 2650.0 / 1674.0);
    // Of the soil, not of its grains; dry_sand has a shear modulus of 76.9 MPa besides.
    double const expected = std::sqrt(265.0 * 265.0 + 4.0 / 3.0 * 76.9e6 / 1674.0);
    EXPECT_NEAR(store.scalar(Field::sound_speed)[i], expected, 1e-6);
    EXPECT_NEAR(store.scalar(Field::pressure)[i], 0.0, 1e-3);
  });
}

// The blast crushes the sand below the charge, and what is crushed stays so while it is thrown out.
TEST(Compaction, NeverGoesBack) {
  Simulation simulation(build_model(bed()));
  auto before = distensions(simulation.particles());
  double const energy = simulation.sums().total_energy();
  while (simulation.running()) {
    simulation.advance();
    for (auto const& [id, alpha] : distensions(simulation.particles())) {
      ASSERT_LE(alpha, before.at(id));
      ASSERT_GE(alpha, 1.0);
      before[id] = alpha;
    }
  }
  EXPECT_LT(least(before), 1.05) << "below the charge hardly a pore is left";
  EXPECT_NEAR(simulation.sums().total_energy() + simulation.lost().energy, energy, 0.005 * energy);
}

TEST(Compaction, GoesOnWithTheSameBits) {
  Case c = bed();
  Simulation straight(build_model(c));
  while (straight.time() < 60e-6) straight.advance();
  auto const path = std::filesystem::temp_directory_path() /
                    ("moraine_compaction_" + std::to_string(getpid()) + ".h5");
  with_hdf5_image([&](Archive& archive) { straight.save(archive); },
                  [&](FileImage image) { write_file(path, image); });
  std::unique_ptr<Simulation> resumed;
  restore_hdf5(path, [&](Archive& archive) {
    resumed = std::make_unique<Simulation>(build_model(c), archive);
  });
  std::filesystem::remove(path);
  EXPECT_TRUE(distensions(resumed->particles()) == distensions(straight.particles()));
  for (int step = 0; step < 60; ++step) {
    straight.advance();
    resumed->advance();
  }
  EXPECT_TRUE(state_by_id(resumed->particles()) == state_by_id(straight.particles()));
  EXPECT_TRUE(distensions(resumed->particles()) == distensions(straight.particles()));
}

TEST(Compaction, DoesNotGoOnFromAStateWithoutIt) {
  Simulation plain(build_model(bed("eos = \"us_up\", reference_density = 2650")));
  MemoryArchive archive;
  plain.save(archive);
  archive.restore();
  EXPECT_THROW(Simulation(build_model(bed()), archive), std::runtime_error);
}

/// The same case from the last state of another, whose sand had these constants.
Case started_from(Simulation const& first, Case const& of) {
  Case next = bed();
  next.regions.clear();
  next.start.run = "first";
  next.start.particles = std::make_shared<ParticleStore>(first.particles());
  next.start.info.time = first.time();
  next.start.info.dimension = 2;
  next.start.info.spacing = next.start.info.finest_spacing = next.numerics.spacing;
  for (MaterialSpec const& material : of.materials)
    next.start.info.materials.push_back({material.name, material_constants(of, material)});
  return next;
}

TEST(Compaction, StaysInACaseThatStartsFromIt) {
  Case const c = bed();
  Simulation first(build_model(c));
  while (first.time() < 60e-6) first.advance();
  auto const values = [](ParticleStore const& store) {  // ids begin anew
    std::vector<double> found;
    for (auto const& [id, alpha] : distensions(store)) found.push_back(alpha);
    std::sort(found.begin(), found.end());
    return found;
  };
  Model const model = build_model(started_from(first, c));
  EXPECT_EQ(values(model.particles), values(first.particles()));
  EXPECT_LT(values(model.particles).front(), 1.2);
}

// Sand that had no pores in the other run begins undisturbed here.
TEST(Compaction, BeginsAnewAfterARunWithoutPores) {
  Case const c =
      bed("eos = \"us_up\", reference_density = 1674, reference_sound_speed = 265, "
          "hugoniot_slope = 1.5");
  Simulation const first(build_model(c));
  Simulation const second(build_model(started_from(first, c)));
  for (auto const& [id, alpha] : distensions(second.particles()))
    EXPECT_DOUBLE_EQ(alpha, 2650.0 / 1674.0) << id;
}

TEST(Compaction, IsRemovedWithTheMaterialThatAStageChanges) {
  Simulation simulation(build_model(bed(sand_keys, R"(
[[stage]]
name = "wait"
until = { after = "5 us" }
[[stage]]
name = "mine"
detonate = "bed"
into = "tnt"
)")));
  while (simulation.stage_events().size() < 2U) simulation.advance();
  auto const& store = simulation.particles();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    EXPECT_EQ(store.scalar(Field::distension)[i], 1.0);
}

/// Mean velocity away from the wall of what flies off after a block was thrown at it.
double rebound(std::string const& material) {
  Simulation simulation(build_model(parse_case(R"(
space = { dimension = 1, domain = { min = [-1.0], max = [2.0] } }
resolution.spacing = 0.005
numerics.precision = "double"
time.end = 6e-3
material.block = { )" + material + R"( }
[[region]]
name = "block"
material = "block"
velocity = ["-100 m/s"]
box = { min = [0.0], max = [0.5] }
[[wall]]
name = "anvil"
container = { min = [0.0], max = [2.0] }
open = ["x+"]
)",
                                               "case.toml")));
  while (simulation.running()) simulation.advance();
  auto const sums = simulation.sums();
  return sums.momentum[0] / sums.mass;
}

// Sand stops where water bounces: most of the energy of the block has become heat.
TEST(Compaction, TakesTheReboundAway) {
  EXPECT_GT(rebound("use = \"water_shock\""), 80.0);
  double const slow = rebound(sand_keys);
  EXPECT_GT(slow, 0.0);
  EXPECT_LT(slow, 15.0);
}

}  // namespace
}  // namespace moraine
