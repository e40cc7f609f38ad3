// The benchmark's own arithmetic: workloads of the stated size, pairs counted right, nothing lost
// on the way to JSON.
#include "bench/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

#include "bench/bench_report.hpp"
#include "bench/process.hpp"
#include "bench/roof.hpp"
#include "setup/build_model.hpp"
#include "setup/fill.hpp"
#include "setup/read_case.hpp"
#include "step/simulation.hpp"
#include "support/places.hpp"

namespace moraine {
namespace {

// A tank small enough to look at all pairs: 10 x 16 x 7 particles of water.
Workload small_dam_break() {
  return {.name = "small",
          .description = "",
          .make = [] { return dam_break(3, 0.04, Precision::mixed); },
          .warm_up = 5,
          .steps = 20};
}

// Directed pairs of a fluid particle with any other closer than 2 h, from the positions alone.
// Those within `doubt` of the limit are counted apart: positions in the pair loops are rounded.
struct BruteForce {
  std::uint64_t pairs = 0;
  std::uint64_t doubtful = 0;
};

BruteForce count_by_brute_force(Simulation const& simulation) {
  ParticleStore const& store = simulation.particles();
  double const reach = kernel_support * simulation.model().numerics.smoothing_length();
  double const doubt = 1e-8 * reach;  // fixed point: 2^-31 of the domain, some 1e-9 m here
  BruteForce result;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    for (std::size_t j = 0; j < store.size(); ++j) {
      if (i == j) continue;
      double distance2 = 0.0;
      for (int axis = 0; axis < store.dimension(); ++axis) {
        auto const x = store.component(Field::position, axis);
        distance2 += (x[i] - x[j]) * (x[i] - x[j]);
      }
      double const distance = std::sqrt(distance2);
      if (std::fabs(distance - reach) < doubt)
        ++result.doubtful;
      else if (distance < reach)
        ++result.pairs;
    }
  return result;
}

TEST(Measure, PairsAreThoseOfBruteForce) {
  for (Precision const precision : {Precision::mixed, Precision::full}) {
    Simulation simulation(build_model(dam_break(3, 0.04, precision)));
    for (int k = 0; k < 10; ++k) simulation.advance();  // off the lattice, lists with a skin in use
    auto const expected = count_by_brute_force(simulation);
    auto const counted = simulation.pairs().count_pairs(simulation.search());
    EXPECT_GT(expected.pairs, 50'000u);
    EXPECT_GE(counted, expected.pairs);
    EXPECT_LE(counted, expected.pairs + expected.doubtful);
  }
}

TEST(Measure, CountsPairsOfTheTimedStepsAlone) {
  Measurement const measured = measure(small_dam_break());
  EXPECT_EQ(measured.warm_up_steps, 5u);
  EXPECT_EQ(measured.steps, 20u);
  EXPECT_GT(measured.wall_particles, measured.particles / 2);
  // Twenty steps move the water by far less than a spacing: pairs per step stay within a percent.
  Simulation simulation(build_model(small_dam_break().make()));
  for (int k = 0; k < 15; ++k) simulation.advance();
  auto const per_step = static_cast<double>(simulation.pairs().count_pairs(simulation.search()));
  EXPECT_NEAR(measured.pairs, 20.0 * per_step, 0.01 * 20.0 * per_step);
  EXPECT_NEAR(measured.neighbours() * static_cast<double>(measured.particles), per_step,
              0.01 * per_step);
}

TEST(Measure, ActionsFillTheTimedSteps) {
  Measurement const measured = measure(small_dam_break());
  double const covered =
      std::accumulate(measured.actions.begin(), measured.actions.end(), 0.0,
                      [](double sum, ActionTime const& action) { return sum + action.seconds; });
  EXPECT_LE(covered, measured.wall_seconds);
  EXPECT_GT(covered,
            0.5 * measured.wall_seconds);  // loose: a busy machine may interrupt in between
  EXPECT_GE(measured.fastest_pairs_per_second_per_core,
            measured.pairs_per_second_per_core * (1.0 - 1e-12));  // rounding of two sums
  EXPECT_GT(measured.counted_bytes, 100u * measured.particles);   // the state alone is 11 doubles
}

TEST(Workloads, HaveTheirStatedParticles) {
  auto const count = [](std::string_view name) {
    return fill_regions(find_workload(name)->make()).size();
  };
  EXPECT_EQ(count("dam-break-3d"), 47u * 78u * 35u);
  EXPECT_EQ(count("dam-break-3d-double"), 128'310u);
  EXPECT_EQ(count("dam-break-2d"), 98'736u);
  EXPECT_EQ(count("tnt-in-water"), 10'000u);
  EXPECT_EQ(count("dam-break-3d-1e4"), 9'900u);
  EXPECT_EQ(count("dam-break-3d-1e5"), 99'072u);
  EXPECT_EQ(count("dam-break-3d-1e6"), 994'635u);
}

TEST(Workloads, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (Workload const& workload : workloads()) {
    EXPECT_TRUE(names.insert(workload.name).second) << workload.name;
    ASSERT_TRUE(find_workload(workload.name).has_value());
    EXPECT_EQ(find_workload(workload.name)->description, workload.description);
  }
  EXPECT_FALSE(find_workload("dam-break").has_value());
}

TEST(Workloads, TntInWaterIsTheShippedCase) {
  Case const shipped = read_case(source_folder() + "/cases/tnt-in-water/case.toml");
  Case const built_in = tnt_in_water();
  EXPECT_EQ(built_in.numerics.spacing, shipped.numerics.spacing);
  EXPECT_EQ(built_in.numerics.smoothing_factor, shipped.numerics.smoothing_factor);
  EXPECT_EQ(built_in.numerics.kernel, shipped.numerics.kernel);
  EXPECT_EQ(built_in.numerics.viscosity_alpha, shipped.numerics.viscosity_alpha);
  EXPECT_EQ(built_in.numerics.viscosity_beta, shipped.numerics.viscosity_beta);
  EXPECT_EQ(built_in.time.end, shipped.time.end);
  auto const ours = fill_regions(built_in), theirs = fill_regions(shipped);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ASSERT_EQ(ours[i].position, theirs[i].position);
    ASSERT_EQ(ours[i].density, theirs[i].density);
    ASSERT_EQ(ours[i].mass, theirs[i].mass);
    ASSERT_EQ(ours[i].specific_energy, theirs[i].specific_energy);
  }
}

// An interior particle of a lattice of spacing 1 has as many neighbours as there are lattice points
// within 2 h of the origin; in a periodic block all particles are interior.
TEST(Workloads, PeriodicBlockHasCompleteNeighbourhoods) {
  Case const c = periodic_block(3, 8, Precision::mixed);
  double const reach = kernel_support * c.numerics.smoothing_length();
  int expected = -1;  // without the particle itself
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -4; z <= 4; ++z) expected += x * x + y * y + z * z < reach * reach ? 1 : 0;
  RoofLine const line = measure_roof("block", build_model(c), SchemeName::liquid, 1, 0.0);
  EXPECT_EQ(line.pairs, 512u * static_cast<std::uint64_t>(expected));
  EXPECT_GE(line.listed_per_pair, 1.0);
  EXPECT_LE(line.median_pairs_per_second_per_core, line.fastest_pairs_per_second_per_core);
}

Measurement sample() {
  Measurement m;
  m.name = "sample";
  m.particles = 1000;
  m.wall_particles = 250;
  m.threads = 2;
  m.steps = 500;
  m.rebuilds = 50;
  m.wall_seconds = 4.0;
  m.processor_seconds = 7.5;
  m.pairs = 1000.0 * 500.0 * 160.0;
  m.pairs_per_second_per_core = m.pairs / 4.0 / 2.0;
  m.peak_bytes = 1'250'000;
  m.counted_bytes = 1'000'000;
  m.actions = {{"sweep", 3.0}, {"search", 0.5}};
  return m;
}

TEST(BenchReport, JsonHasTheDocumentedKeys) {
  auto const json = to_json(sample());
  EXPECT_EQ(json.at("particles"), 1000);
  EXPECT_EQ(json.at("wall_particles"), 250);
  EXPECT_EQ(json.at("threads"), 2);
  EXPECT_EQ(json.at("steps"), 500);
  EXPECT_DOUBLE_EQ(json.at("neighbours"), 160.0);
  EXPECT_DOUBLE_EQ(json.at("neighbour_interactions_per_second_per_core"), 1e7);
  EXPECT_DOUBLE_EQ(json.at("particle_steps_per_second"), 125'000.0);
  EXPECT_DOUBLE_EQ(json.at("bytes_per_particle"), 1250.0);
  EXPECT_DOUBLE_EQ(json.at("bytes_per_particle_with_walls"), 1000.0);
  EXPECT_EQ(json.at("simulation_bytes"), 1'000'000);
  EXPECT_DOUBLE_EQ(json.at("steps_per_rebuild"), 10.0);
  EXPECT_DOUBLE_EQ(json.at("processor_seconds"), 7.5);
  EXPECT_DOUBLE_EQ(json.at("neighbour_interactions_per_processor_second"), 8e7 / 7.5);
  EXPECT_DOUBLE_EQ(json.at("action_seconds").at("sweep"), 3.0);
  EXPECT_DOUBLE_EQ(json.at("action_shares").at("sweep"), 0.75);
}

TEST(BenchReport, NoRebuildIsNull) {
  Measurement m = sample();
  m.rebuilds = 0;
  EXPECT_TRUE(to_json(m).at("steps_per_rebuild").is_null());
  EXPECT_NE(figures_table(std::span(&m, 1)).find(">500"), std::string::npos);
}

TEST(BenchReport, JsonComesBackUnchanged) {
  auto const json = to_json(sample());
  auto const text = json.dump();
  EXPECT_EQ(to_json(measurement_from_json(nlohmann::ordered_json::parse(text))), json);
}

TEST(BenchReport, TablesShowFiguresAndWhatNoActionCovers) {
  Measurement const m = sample();
  EXPECT_NE(figures_table(std::span(&m, 1)).find("sample"), std::string::npos);
  std::string const table = actions_table(m);
  EXPECT_LT(table.find("sweep"), table.find("search"));
  EXPECT_NE(table.find("other"), std::string::npos);
  EXPECT_NE(table.find("12.5"), std::string::npos);  // search and other: 0.5 s of 4 s each
}

TEST(Process, ChildReturnsItsTextAndItsError) {
  int here = 0;
  EXPECT_EQ(in_child([&] { return "said " + std::to_string(++here); }), "said 1");
  EXPECT_EQ(here, 0);  // another process
  try {
    in_child([]() -> std::string { throw std::runtime_error("broken"); });
    FAIL() << "no error";
  } catch (std::runtime_error const& error) {
    EXPECT_STREQ(error.what(), "broken");
  }
}

TEST(Process, MemoryGrowsByWhatIsTouched) {
  std::size_t const size = 64u << 20;
  auto const grown = in_child([&] {
    std::size_t const before = resident_memory().now;
    std::string const block(size, 'x');
    std::size_t const peak = resident_memory().peak;
    return std::to_string(peak - before + (block.back() == 'x' ? 0 : 1));
  });
  EXPECT_GE(std::stoul(grown), size - (1u << 20));  // pages that were resident before and reused
  EXPECT_LE(std::stoul(grown), size + size / 4);    // the allocator, and checkers of memory
}

}  // namespace
}  // namespace moraine
