// A case that starts from the end state of another run: settle once, explode several times.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "end_to_end/start_from_a_run.hpp"
#include "output/checkpoint/run_state.hpp"
#include "output/checkpoint/start_reader.hpp"
#include "output/manifest.hpp"
#include "setup/build_model.hpp"
#include "setup/case_report.hpp"
#include "setup/case_size.hpp"
#include "setup/start_particles.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

std::vector<std::size_t> by_id(ParticleStore const& store) {
  std::vector<std::size_t> order(store.range(Kind::fluid).size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return store.id()[a] < store.id()[b]; });
  return order;
}

/// All that the particles of a run take along, in the order of their ids.
std::vector<std::uint64_t> state_bits(ParticleStore const& store) {
  std::vector<std::uint64_t> bits;
  for (std::size_t const i : by_id(store)) {
    for (int axis = 0; axis < store.dimension(); ++axis)
      for (Field const field : {Field::position, Field::velocity})
        bits.push_back(std::bit_cast<std::uint64_t>(store.component(field, axis)[i]));
    for (Field const field : {Field::density, Field::specific_energy, Field::mass})
      bits.push_back(std::bit_cast<std::uint64_t>(store.scalar(field)[i]));
    bits.push_back(store.material()[i]);
  }
  return bits;
}

TEST_F(StartFromARun, HasItsParticlesToTheLastBit) {
  std::string text = pool("0.01") + from_settled;
  text.replace(text.find("spacing = 0.02"), 14, "spacing = \"2 cm\"");
  Model const model = build_model(started(text));
  RestoredRun const settled = end_of("settled");
  EXPECT_EQ(model.particles.range(Kind::fluid).size(), 600U);
  EXPECT_TRUE(state_bits(model.particles) == state_bits(settled.simulation->particles()));
  ConservedSums const before = settled.simulation->sums();
  Simulation const next(model);
  ConservedSums const after = next.sums();
  // The sums run over other orders of the same 600 numbers.
  EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
  EXPECT_NEAR(after.total_energy(), before.total_energy(), 1e-12 * before.potential_energy);
  EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 1e-13 * before.kinetic_energy);
  EXPECT_GT(after.kinetic_energy, 0.0);
  EXPECT_EQ(next.time(), 0.0);
}

TEST_F(StartFromARun, CanBringThemToRest) {
  Case const c = started(pool("0.01") + from_settled + "velocities = \"zero\"\n");
  Model const model = build_model(c);
  for (int axis = 0; axis < 2; ++axis)
    for (double const v : model.particles.component(Field::velocity, axis)) EXPECT_EQ(v, 0.0);
  EXPECT_EQ(Simulation(model).sums().kinetic_energy, 0.0);
}

// The disc replaces water; the pellet in its middle replaces some of the disc.
TEST_F(StartFromARun, RegionsReplaceWhatTheyFill) {
  Case const c = started(pool("0.01") + from_settled + charge);
  Model const model = build_model(c);
  auto const kept = kept_start_particles(c);
  std::size_t const fluid = model.particles.range(Kind::fluid).size();
  EXPECT_LT(kept.size(), 600U);
  // 0.05 m is 2.5 spacings: about 20 particles of water gave way.
  EXPECT_NEAR(static_cast<double>(600 - kept.size()), 19.6, 4.0);
  for (std::size_t i = 0; i < fluid; ++i) {
    double const x = model.particles.component(Field::position, 0)[i] - 0.3;
    double const y = model.particles.component(Field::position, 1)[i] - 0.2;
    bool const inside = std::hypot(x, y) <= 0.05;
    EXPECT_EQ(model.materials[model.particles.material()[i]].name, inside ? "tnt" : "water");
    EXPECT_EQ(model.particles.id()[i], i) << "renumbered: those of the other run come first";
  }
  auto const sums = [](Case const& of) { return estimate_size(of).fluid; };
  EXPECT_NEAR(sums(c), static_cast<double>(fluid), 40.0);
}

TEST_F(StartFromARun, SettlesThenExplodesAndGoesOnWithoutTheOtherRun) {
  write(path("explode.toml"), pool("0.01") + from_settled + "velocities = \"zero\"\n" + charge);
  CommandResult const straight = run("explode.toml", "straight");
  ASSERT_EQ(straight.code, 0) << straight.err;
  EXPECT_NE(straight.out.find("particles from step_"), std::string::npos) << straight.out;
  Program program(path(""), {"run", "explode.toml", "-o", "stopped"});
  wait_for_checkpoints("stopped", 2);
  program.send(SIGINT);
  ASSERT_EQ(program.wait().code, 130) << "over before the signal came";
  std::filesystem::remove_all(path("settled"));
  std::filesystem::remove(path("settle.toml"));
  CommandResult const resumed = moraine_command(path(""), {"resume", "stopped"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  auto const first = results("straight");
  auto const second = results("stopped");
  EXPECT_EQ(first.size(), second.size());
  for (auto const& [name, bytes] : first) EXPECT_TRUE(second.at(name) == bytes) << name;
  EXPECT_GT(first.size(), 9U) << "frames of every 2 ms";
  // A third run goes on from this one, which holds all that it needs.
  Case const c = [&] {
    std::string text = pool("0.01") + from_settled;
    text.replace(text.find("\"settled\""), 9, "\"stopped\"");
    return started(text);
  }();
  RestoredRun const stopped = end_of("stopped");
  EXPECT_TRUE(state_bits(build_model(c).particles) == state_bits(stopped.simulation->particles()));
  EXPECT_EQ(build_model(c).finest_spacing, stopped.simulation->model().finest_spacing);
}

TEST_F(StartFromARun, ManifestNamesTheStateByItsDigest) {
  write(path("next.toml"), pool("0.0005") + from_settled);
  ASSERT_EQ(run("next.toml", "next").code, 0);
  std::vector<std::string> skipped;
  auto const checkpoint = *Checkpoints(path("settled")).newest(skipped);
  auto const manifest = nlohmann::json::parse(bytes_of(path("next/manifest.json")));
  EXPECT_EQ(manifest["start"]["run"], "settled");
  EXPECT_EQ(manifest["start"]["checkpoint"], checkpoint.filename().string());
  EXPECT_EQ(manifest["start"]["sha256"], file_sha256(checkpoint));
  EXPECT_EQ(manifest["start"]["time_s"], 0.02);
  auto const other = nlohmann::json::parse(bytes_of(path("settled/manifest.json")));
  EXPECT_FALSE(other.contains("start"));
  // The case that was really used starts from the same place, wherever it lies.
  Case const used = read_case(path("next/case.used.toml"));
  EXPECT_EQ(used_case(used), used_case(read_case(path("next.toml"))));
  write(path("settle.toml"), pool("0.0005") + water);
  ASSERT_EQ(moraine_command(path(""), {"run", "settle.toml", "-o", "next", "--force"}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("next/start.h5"))) << "of the run before";
}

TEST_F(StartFromARun, OtherCommandsKnowTheState) {
  std::string const text = pool("0.01") + from_settled + charge;
  CommandResult const preview = command("preview", text);
  EXPECT_EQ(preview.code, 0) << preview.err;
  EXPECT_NE(preview.out.find("from settled: "), std::string::npos) << preview.out;
  EXPECT_NE(preview.out.find(" more replaced by regions"), std::string::npos) << preview.out;
  CommandResult const check = command("check", text);
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find(" of water"), std::string::npos) << check.out;
  CommandResult const step = moraine_command(path(""), {"explain", "--step", "next.toml"});
  EXPECT_EQ(step.code, 0) << step.err;
  EXPECT_NE(step.out.find(" of settled, time 0.02 s"), std::string::npos) << step.out;
}

}  // namespace
}  // namespace moraine
