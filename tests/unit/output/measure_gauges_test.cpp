// Gauges that measure shapes and formulas, in a run: what they read, and that a saved state gives
// the same readings to the last bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "output/atomic_file.hpp"
#include "output/checkpoint/hdf5_archive.hpp"
#include "output/probe_recorder.hpp"
#include "scratch_folder.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

constexpr char const* slide = R"(
space = { dimension = 2, domain = { min = [-0.5, -0.5], max = [0.9, 1.0] } }
physics.gravity = [0.0, -9.81]
resolution.spacing = 0.02
numerics = { viscosity_alpha = 0.1, viscosity_beta = 0.0, density_diffusion = 0.1 }
time.end = 1.0
output.arrival_pressure = 500
material.water = { eos = "tait", reference_sound_speed = 25.0 }
material.oil = { eos = "tait", reference_sound_speed = 25.0, reference_density = 800.0 }
[[region]]
name = "column"
material = "water"
hydrostatic_level = 0.3
box = { min = [0.0, 0.0], max = [0.4, 0.3] }
[[region]]
name = "drop"
material = "water"
velocity = [0.0, 2.0]
box = { min = [0.5, 0.2], max = [0.56, 0.26] }
[[region]]
name = "pocket"
material = "oil"
box = { min = [0.1, 0.1], max = [0.2, 0.16] }
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [0.8, 0.6] }
open = ["y+"]
[[gauge]]
name = "away"
kind = "line"
line = { from = [0.3, 0.05], to = [0.38, 0.05], points = 3, origin = [0.2, 0.05] }
[[gauge]]
name = "hole"
kind = "crater"
materials = ["water"]
crater = { level = 0.3, center = [0.2, 0.3], radius = 0.18 }
[[gauge]]
name = "flow"
kind = "deposit"
materials = ["water", "oil"]
deposit = { base = 0.0, along = "x+" }
[[gauge]]
name = "pocket"
kind = "bubble"
materials = ["oil"]
[[gauge]]
name = "surface"
kind = "rise"
within = { min = [0.0, 0.0], max = [0.4, 0.6] }
[[gauge]]
name = "energy"
kind = "expression"
formula = "0.5 * mass * speed^2"
reduce = "sum"
unit = "J"
[[gauge]]
name = "field"
kind = "plane"
plane = { min = [0.0, 0.0], max = [0.8, 0.6], step = 0.05 }
)";

class MeasureGauges : public ScratchFolder {
 protected:
  Case const case_ = parse_case(slide, "slide");

  static double value(ProbeRecorder const& probes, std::vector<double> const& row,
                      std::string const& column) {
    for (std::size_t k = 0; k < row.size(); ++k)
      if (probes.columns()[k].name == column) return row[k];
    ADD_FAILURE() << "no column " << column;
    return 0.0;
  }
  nlohmann::json summary(ProbeRecorder const& probes) {
    probes.write_summary(path("gauges.json"));
    return nlohmann::json::parse(bytes_of(path("gauges.json")));
  }
};

// The drop, 3 x 3 of 309 particles, hangs in the air and belongs to nothing.
TEST_F(MeasureGauges, ReadTheStart) {
  Simulation const simulation(build_model(case_));
  ProbeRecorder probes(case_);
  auto const row = probes.read(simulation);
  EXPECT_EQ(value(probes, row, "hole depth"), 0.0);
  EXPECT_NEAR(value(probes, row, "flow run_out"), 0.4, 0.002);
  EXPECT_NEAR(value(probes, row, "flow height"), 0.3, 0.002);
  EXPECT_EQ(value(probes, row, "flow detached_particles"), 9.0);
  EXPECT_NEAR(value(probes, row, "flow detached_share"), 9.0 / 309.0, 0.003);
  EXPECT_NEAR(value(probes, row, "pocket volume"), 0.1 * 0.06, 1e-5);
  EXPECT_NEAR(value(probes, row, "pocket radius"), std::sqrt(0.006 / M_PI), 1e-4);
  EXPECT_NEAR(value(probes, row, "pocket center_x"), 0.15, 1e-6);
  EXPECT_NEAR(value(probes, row, "pocket low_y"), 0.1, 1e-4);
  EXPECT_NEAR(value(probes, row, "surface highest"), 0.3, 0.1 * 0.02);
  EXPECT_EQ(value(probes, row, "surface rise"), 0.0);
  double const drop = 9 * 1000.0 * 0.02 * 0.02;
  EXPECT_NEAR(value(probes, row, "energy sum"), 0.5 * drop * 4.0, 0.02);
  auto const& columns = probes.columns();
  EXPECT_EQ(columns.back().name, "energy sum");
  EXPECT_EQ(columns.back().unit, "J");
}

// The sum of the formula is the kinetic energy of the run, summed in another order.
TEST_F(MeasureGauges, FollowTheRun) {
  Simulation simulation(build_model(case_));
  ProbeRecorder probes(case_);
  double const first = value(probes, probes.read(simulation), "surface highest");
  for (int step = 0; step < 60; ++step) simulation.advance();
  auto const row = probes.read(simulation);
  double const kinetic = simulation.sums().kinetic_energy;
  EXPECT_NEAR(value(probes, row, "energy sum"), kinetic, 1e-12 * kinetic);
  EXPECT_DOUBLE_EQ(value(probes, row, "surface rise"),
                   value(probes, row, "surface highest") - first);
  EXPECT_GT(value(probes, row, "flow run_out"), 0.4);
}

TEST_F(MeasureGauges, TheSummaryTellsHowPeaksFallOff) {
  Simulation simulation(build_model(case_));
  ProbeRecorder probes(case_);
  for (int step = 0; step < 40; ++step) {
    probes.read(simulation);
    simulation.advance();
  }
  auto const gauges = summary(probes).at("gauges");
  auto const decay = gauges.at(0).at("decay");
  EXPECT_GE(decay.at("points").get<int>(), 0);
  EXPECT_TRUE(decay.contains("exponent"));
  EXPECT_TRUE(decay.contains("scatter"));
  EXPECT_TRUE(gauges.at(0).at("columns").at("away[1] pressure").contains("duration"));
  EXPECT_FALSE(gauges.at(0).at("columns").at("away[1] density").contains("duration"));
  EXPECT_FALSE(gauges.at(1).contains("decay"));
  EXPECT_TRUE(gauges.at(6).at("columns").empty()) << "a plane has files instead";
}

TEST_F(MeasureGauges, GoOnFromASavedStateToTheLastBit) {
  Simulation simulation(build_model(case_));
  ProbeRecorder straight(case_);
  straight.read(simulation);
  for (int step = 0; step < 33; ++step) simulation.advance();
  straight.read(simulation);
  auto const image = path("state.h5");
  with_hdf5_image(
      [&](Archive& archive) {
        simulation.save(archive);
        straight.exchange(archive);
      },
      [&](FileImage bytes) { write_file(image, bytes); });
  std::unique_ptr<Simulation> other;
  ProbeRecorder resumed(case_);
  restore_hdf5(image, [&](Archive& archive) {
    other = std::make_unique<Simulation>(build_model(case_), archive);
    resumed.exchange(archive);
  });
  for (int step = 0; step < 20; ++step) {
    simulation.advance();
    other->advance();
    auto const a = straight.read(simulation);
    auto const b = resumed.read(*other);
    for (std::size_t k = 0; k < a.size(); ++k)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a[k]), std::bit_cast<std::uint64_t>(b[k]))
          << straight.columns()[k].name << " in step " << step;
  }
  EXPECT_EQ(summary(straight).dump(), summary(resumed).dump());
}

// Readings look on: a run with gauges has the bits of one without.
TEST_F(MeasureGauges, ChangeNoStep) {
  Simulation watched(build_model(case_));
  Simulation alone(build_model(case_));
  ProbeRecorder probes(case_);
  for (int step = 0; step < 25; ++step) {
    probes.read(watched);
    watched.advance();
    alone.advance();
  }
  auto const a = watched.particles().component(Field::velocity, 1);
  auto const b = alone.particles().component(Field::velocity, 1);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i]), std::bit_cast<std::uint64_t>(b[i]));
}

}  // namespace
}  // namespace moraine
