// Gauges of all kinds read what is there, remember what was, and go on from a saved state.
#include "output/probe_recorder.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "output/atomic_file.hpp"
#include "output/checkpoint/hdf5_archive.hpp"
#include "output/vtp_reader.hpp"
#include "scratch_folder.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

constexpr char const* dam = R"(
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
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [0.8, 0.6] }
open = ["y+"]
[[gauge]]
name = "across"
kind = "line"
line = { from = [0.2, 0.05], to = [0.2, 0.25], points = 5 }
[[gauge]]
name = "tank"
kind = "wall"
wall = "tank"
[[gauge]]
name = "height"
kind = "level"
level = { from = [0.1, 0.05], to = [0.1, 0.5] }
[[gauge]]
name = "water"
kind = "sums"
of = "water"
[[gauge]]
name = "oil"
kind = "sums"
of = "oil"
[[gauge]]
name = "right"
kind = "side"
side = "x+"
[[gauge]]
name = "energy"
kind = "budget"
[[gauge]]
name = "sky"
position = [0.4, 0.9]
)";

double value(ProbeRecorder const& probes, std::vector<double> const& row,
             std::string const& column) {
  for (std::size_t k = 0; k < row.size(); ++k)
    if (probes.columns()[k].name == column) return row[k];
  ADD_FAILURE() << "no column " << column;
  return 0.0;
}

class Probes : public ScratchFolder {
 protected:
  Case const case_ = parse_case(dam, "dam");

  nlohmann::json summary(ProbeRecorder const& probes) {
    probes.write_summary(path("gauges.json"));
    return nlohmann::json::parse(bytes_of(path("gauges.json")));
  }
};

// Interpolation with the volumes as weights gives a linear field to a fraction of the spacing that
// the lattice's asymmetry about the point allows: a tenth.
TEST_F(Probes, ALineShowsALinearField) {
  Simulation const simulation(build_model(case_));
  ProbeRecorder probes(case_);
  probes.tell(simulation);
  auto const row = probes.read(simulation);
  double const gradient = 1000.0 * 9.81;
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(value(probes, row, "across[" + std::to_string(k + 1) + "] pressure"),
                gradient * (0.25 - 0.05 * k), 0.1 * gradient * 0.02);
  EXPECT_NEAR(value(probes, row, "height level"), 0.3, 0.1 * 0.02);
}

TEST_F(Probes, SumsOfAMaterialAreThoseOfTheRun) {
  Simulation simulation(build_model(case_));
  ProbeRecorder probes(case_);
  probes.tell(simulation);
  for (int step = 0; step < 20; ++step) {
    simulation.advance();
    probes.tell(simulation);
  }
  auto const row = probes.read(simulation);
  ConservedSums const sums = simulation.sums();
  EXPECT_EQ(value(probes, row, "water particles"), 300.0);
  EXPECT_DOUBLE_EQ(value(probes, row, "water kinetic_energy"), sums.kinetic_energy);
  EXPECT_DOUBLE_EQ(value(probes, row, "water internal_energy"), sums.internal_energy);
  EXPECT_DOUBLE_EQ(value(probes, row, "water potential_energy"), sums.potential_energy);
  EXPECT_DOUBLE_EQ(value(probes, row, "water momentum_x"), sums.momentum[0]);
  EXPECT_EQ(value(probes, row, "oil mass"), 0.0);
  EXPECT_GT(value(probes, row, "energy viscosity"), 0.0);
}

TEST_F(Probes, GaugesThatHaveSeenNothingSaySo) {
  Simulation const simulation(build_model(case_));
  ProbeRecorder probes(case_);
  probes.tell(simulation);
  probes.read(simulation);
  EXPECT_EQ(probes.remarks(), (std::vector<std::string>{"gauge \"oil\" has seen nothing",
                                                        "gauge \"right\" has seen nothing",
                                                        "gauge \"sky\" has seen nothing"}));
  auto const gauges = summary(probes).at("gauges");
  EXPECT_EQ(gauges.size(), 8U);
  EXPECT_EQ(gauges[1].at("seen"), true);
  EXPECT_EQ(gauges[7].at("seen"), false);
  EXPECT_TRUE(gauges[7].at("columns").at("sky pressure").at("largest").is_null());
}

// The state of probes goes through a checkpoint: the same readings and the same summary.
TEST_F(Probes, GoOnFromASavedState) {
  Simulation simulation(build_model(case_));
  ProbeRecorder straight(case_);
  straight.tell(simulation);
  straight.read(simulation);
  auto const advance = [&](ProbeRecorder& probes, Simulation& run, int steps) {
    for (int step = 0; step < steps; ++step) {
      run.advance();
      probes.tell(run);
      if (step % 3 == 2) probes.read(run);
    }
  };
  advance(straight, simulation, 31);
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
  advance(straight, simulation, 30);
  advance(resumed, *other, 30);
  EXPECT_EQ(summary(straight).dump(), summary(resumed).dump());
  auto const arrays = straight.envelopes();
  auto const arrays_again = resumed.envelopes();
  ASSERT_EQ(arrays.size(), 4U);
  for (std::size_t k = 0; k < arrays.size(); ++k)
    for (std::size_t i = 0; i < arrays[k].by_id.size(); ++i)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(arrays[k].by_id[i]),
                std::bit_cast<std::uint64_t>(arrays_again[k].by_id[i]))
          << arrays[k].name;
}

// What walls bear is known from pairs, and a restored run has none before its first step.
TEST_F(Probes, LoadsOfARestoredRunAreKnownAfterItsFirstStep) {
  Simulation simulation(build_model(case_));
  simulation.advance();
  auto const image = path("state.h5");
  with_hdf5_image([&](Archive& archive) { simulation.save(archive); },
                  [&](FileImage bytes) { write_file(image, bytes); });
  std::unique_ptr<Simulation> restored;
  restore_hdf5(image, [&](Archive& archive) {
    restored = std::make_unique<Simulation>(build_model(case_), archive);
  });
  ProbeRecorder probes(case_);
  EXPECT_TRUE(std::isnan(value(probes, probes.read(*restored), "tank force_y")));
  restored->advance();
  EXPECT_LT(value(probes, probes.read(*restored), "tank force_y"), 0.0);
}

TEST_F(Probes, EnvelopesGoWithTheFramesByParticle) {
  ParticleStore store(1);
  store.append(Kind::fluid, 0);
  store.append(Kind::fluid, 0);
  std::array<std::uint32_t, 2> const swapped{1, 0};
  store.permute(Kind::fluid, swapped);
  std::vector<double> const by_id{0.25, 0.5};
  write_vtp(path("frame.vtp"), store, Kind::fluid, 0.0, {{"arrival", "s", by_id}});
  ParticleFrame const frame = read_vtp(path("frame.vtp"));
  FrameArray const* const arrival = frame.find("arrival");
  ASSERT_NE(arrival, nullptr);
  EXPECT_EQ(arrival->unit, "s");
  EXPECT_EQ(arrival->values, (std::vector<double>{0.5, 0.25}));
}

}  // namespace
}  // namespace moraine
