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

#include "output/checkpoint/checkpoints.hpp"
#include "output/checkpoint/run_state.hpp"
#include "output/checkpoint/start_reader.hpp"
#include "output/manifest.hpp"
#include "setup/build_model.hpp"
#include "setup/case_report.hpp"
#include "setup/case_size.hpp"
#include "setup/read_case.hpp"
#include "setup/start_particles.hpp"
#include "setup/used_case.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

// Everything but regions, start and end.
std::string pool(std::string const& end, std::string const& sound_speed = "100") {
  return R"(space.dimension = 2
physics.gravity = [0.0, -9.81]
resolution.spacing = 0.02
numerics.continuity = "volume"
time.end = )" +
         end + R"(
output = { frames = "2 ms", gauges = "1 ms", checkpoints = "20 ms" }
[material.water]
eos = "tait"
reference_sound_speed = )" +
         sound_speed + R"(
[material.tnt]
use = "tnt"
[[wall]]
name = "tank"
container = { min = [0, 0], max = [1, 0.8] }
open = ["y+"]
[[gauge]]
name = "wall"
position = [0.96, 0.05]
)";
}

constexpr char const* water = R"([[region]]
name = "water"
material = "water"
box = { min = [0, 0], max = [0.6, 0.4] }
)";
constexpr char const* from_settled = "[start]\nrun = \"settled\"\n";
constexpr char const* charge = R"([[region]]
name = "charge"
material = "tnt"
disc = { center = [0.3, 0.2], radius = 0.05 }
equal_mass_with = "pellet"
[[region]]
name = "pellet"
material = "tnt"
box = { min = [0.28, 0.18], max = [0.32, 0.22] }
)";

class StartFromARun : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("settle.toml"), pool("0.02") + water);
    ASSERT_EQ(run("settle.toml", "settled").code, 0);
  }
  CommandResult run(std::string const& file, std::string const& folder) {
    return moraine_command(path(""), {"run", file, "-o", folder});
  }
  CommandResult command(std::string const& name, std::string const& text) {
    write(path("next.toml"), text);
    std::vector<std::string> arguments{name, "next.toml"};
    if (name == "preview") arguments.insert(arguments.end(), {"--output", "pictures"});
    return moraine_command(path(""), arguments);
  }
  Case started(std::string const& text) {
    write(path("next.toml"), text);
    Case c = read_case(path("next.toml"));
    read_start(c);
    return c;
  }
  RestoredRun end_of(std::string const& folder) {
    std::vector<std::string> skipped;
    return restore_run(*Checkpoints(path(folder)).newest(skipped), path(folder), 1);
  }
  /// All results with their content. HDF5 files and the manifest hold times of the clock.
  std::map<std::string, std::string> results(std::string const& folder) const {
    std::map<std::string, std::string> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(path(folder))) {
      std::string const name = std::filesystem::relative(entry.path(), path(folder)).string();
      if (entry.is_regular_file() && name != "manifest.json" && name != "start.h5" &&
          !name.starts_with("checkpoints"))
        files[name] = bytes_of(entry.path());
    }
    return files;
  }
  /// Waits until a run that has been started has saved its state so often.
  void wait_for_checkpoints(std::string const& folder, std::ptrdiff_t wanted) const {
    auto const count = [&] {
      std::error_code none;
      std::filesystem::directory_iterator files(path(folder) / "checkpoints", none);
      return std::count_if(begin(files), end(files),
                           [](auto const& e) { return e.path().extension() == ".h5"; });
    };
    for (int tries = 0; tries < 6000 && count() < wanted; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  std::string mistake(std::string const& text) {
    std::string const all = message_of<InputErrors>([&] { started(text); });
    return all.substr(all.find("next.toml") + 10);
  }
};

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

TEST_F(StartFromARun, DoubtsOtherConstantsAndRunsThatAreNotOver) {
  auto const warnings = [&](std::string const& text) {
    std::string all;
    for (auto const& warning : report_case(started(text)).warnings) all += format(warning) + '\n';
    return all;
  };
  EXPECT_EQ(warnings(pool("0.01") + from_settled).find("start.run"), std::string::npos);
  EXPECT_NE(
      warnings(pool("0.01", "90") + from_settled)
          .find("material.water: is another one in the run that the case starts from: "
                "\"reference_sound_speed = 100.0  # m/s\" there, \"reference_sound_speed = 90.0  "
                "# m/s\" here; its particles keep density and energy, not pressure"),
      std::string::npos)
      << warnings(pool("0.01", "90") + from_settled);
  std::string half(water);
  half.replace(half.find("0.6, 0.4"), 8, "0.5, 0.5");
  EXPECT_NE(warnings(pool("0.01") + from_settled + half)
                .find("start.run: \"settled\" loses 500 of its 600 particles to regions of this "
                      "case"),
            std::string::npos)
      << warnings(pool("0.01") + from_settled + half);
  write(path("settle.toml"), pool("100") + water);
  Program program(path(""), {"run", "settle.toml", "-o", "unfinished"});
  wait_for_checkpoints("unfinished", 1);
  program.send(SIGINT);
  ASSERT_EQ(program.wait().code, 130);
  std::string unfinished = pool("0.01") + from_settled;
  unfinished.replace(unfinished.find("\"settled\""), 9, "\"unfinished\"");
  std::string const text = warnings(unfinished);
  EXPECT_NE(text.find("start.run: \"unfinished\" had not reached its end: the state is that of "),
            std::string::npos)
      << text;
}

TEST_F(StartFromARun, RefusesWhatDoesNotGoTogether) {
  auto const swapped = [](std::string text, std::string const& from, std::string const& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  std::string const good = pool("0.01") + from_settled;
  EXPECT_EQ(mistake(swapped(good, "\"settled\"", "\"setled\"")),
            "20:7: start.run: \"setled\" is not a folder; name the folder of a run; its path "
            "counts from the case file");
  EXPECT_EQ(
      mistake(swapped(good, "[start]\nrun = \"settled\"\n", "[start]\nvelocities = \"zero\"\n")),
      "19:1: start.run: is missing: folder of another run, from whose newest checkpoint the "
      "case takes its particles; its path counts from the case file");
  std::filesystem::create_directories(path("empty"));
  EXPECT_EQ(mistake(swapped(good, "\"settled\"", "\"empty\"")),
            "20:7: start.run: \"empty\" holds no run; name the folder of a run");
  EXPECT_EQ(mistake(swapped(good, "spacing = 0.02", "spacing = 0.01")),
            "3:22: resolution.spacing: 0.01 differs from the spacing of the run that the case "
            "starts from, 0.02 m");
  EXPECT_EQ(mistake(swapped(good, "[material.water]", "[material.watr]")),
            "20:7: start.run: \"settled\" holds particles of the material \"water\", which this "
            "case does not have; did you mean \"watr\"?");
  EXPECT_EQ(mistake("space.dimension = 1\nresolution.spacing = 0.02\ntime.end = 1\n"
                    "[space.domain]\nmin = [0]\nmax = [1]\n"
                    "[material.water]\neos = \"tait\"\n" +
                    std::string(from_settled)),
            "1:19: space.dimension: 1 differs from the dimension of the run that the case starts "
            "from, 2");
  std::string const narrow = mistake(swapped(good, "max = [1, 0.8]", "max = [0.5, 0.8]"));
  EXPECT_TRUE(narrow.starts_with("20:7: start.run: \"settled\" has ")) << narrow;
  EXPECT_NE(narrow.find(" particles inside a wall, the first at (0.5"), std::string::npos)
      << narrow;
  EXPECT_EQ(
      mistake(good + swapped(water, "max = [0.6, 0.4]", "max = [1, 0.8]")),
      "20:7: start.run: \"settled\" has no particle that stays: regions of this case fill all "
      "their places; leave out the regions that the other run began with");
  std::string small = swapped(good, "max = [1, 0.8]", "max = [0.3, 0.8]");
  small = mistake(swapped(small, "[0.96, 0.05]", "[0.2, 0.05]") +
                  "[space.domain]\nmin = [0, 0]\nmax = [0.3, 0.8]\n");
  EXPECT_NE(small.find(" particles outside the domain, the first at (0.3"), std::string::npos)
      << small;
}

TEST_F(StartFromARun, RefusesDamagedStatesAndItsOwnFolder) {
  std::string const good = pool("0.001") + from_settled;
  write(path("next.toml"), good);
  CommandResult const own =
      moraine_command(path(""), {"run", "next.toml", "-o", "settled", "--force"});
  EXPECT_EQ(own.code, 2);
  EXPECT_NE(own.err.find("next.toml:20:7: start.run: \"settled\" is the folder of this run's own "
                         "results; choose another folder with --output"),
            std::string::npos)
      << own.err;
  ASSERT_EQ(run("next.toml", "next").code, 0);
  write(path("next/start.h5"), "moraine checkpoint, cut");
  std::filesystem::remove(path("next/manifest.json"));  // as if it was killed
  CommandResult const resumed = moraine_command(path(""), {"resume", "next"});
  EXPECT_EQ(resumed.code, 1);
  EXPECT_NE(resumed.err.find("start.h5 is cut off: the state that the run started from is lost"),
            std::string::npos)
      << resumed.err;
  for (auto const& entry : std::filesystem::directory_iterator(path("settled/checkpoints")))
    write(entry.path(), "moraine checkpoint, cut");
  std::string const text = mistake(good);
  EXPECT_TRUE(text.starts_with("20:7: start.run: \"settled\" has no whole checkpoint; ")) << text;
  EXPECT_NE(text.find(" is cut off"), std::string::npos) << text;
}

}  // namespace
}  // namespace moraine
