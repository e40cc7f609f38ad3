// A small blast on the ground with all derived measures: readings, planes, surfaces; the same after
// it was stopped.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

/// A block of gas at 20 MPa on water that is to become a hole.
constexpr char const* blast = R"(
space = { dimension = 2, domain = { min = [-0.3, -0.3], max = [0.3, 0.4] } }
physics.gravity = [0.0, -9.81]
resolution.spacing = 0.02
time.end = "0.8 ms"
output = { frames = "0.2 ms", gauges = "20 us", arrival_pressure = "0.2 MPa" }
material.water = { eos = "tait", reference_sound_speed = 300.0 }
material.gas = { eos = "ideal_gas", heat_capacity_ratio = 1.4, reference_density = 1000.0 }
[[region]]
name = "ground"
material = "water"
box = { min = [-0.3, -0.3], max = [0.3, 0.0] }
[[region]]
name = "charge"
material = "gas"
pressure = "20 MPa"
density = 1000.0
box = { min = [-0.04, -0.04], max = [0.04, 0.04] }
[[wall]]
name = "box"
container = { min = [-0.3, -0.3], max = [0.3, 0.4] }
open = ["y+"]
[[gauge]]
name = "below"
kind = "line"
line = { from = [0.0, -0.1], to = [0.0, -0.25], points = 6, origin = [0.0, 0.0] }
[[gauge]]
name = "crater"
kind = "crater"
materials = ["water"]
crater = { level = 0.0, center = [0.0, 0.0] }
[[gauge]]
name = "ground"
kind = "deposit"
materials = ["water"]
deposit = { base = -0.3, origin = [0.0, 0.0] }
[[gauge]]
name = "fireball"
kind = "bubble"
materials = ["gas"]
[[gauge]]
name = "surface"
kind = "rise"
materials = ["water"]
[[gauge]]
name = "hottest"
kind = "expression"
formula = "specific_energy"
reduce = "max"
materials = ["gas"]
unit = "J/kg"
[[gauge]]
name = "section"
kind = "plane"
plane = { min = [-0.3, -0.3], max = [0.3, 0.3], step = 0.02 }
)";

class DerivedMeasures : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("case.toml"), blast);
  }
  CommandResult call(std::vector<std::string> const& arguments) {
    return moraine_command(path(""), arguments);
  }
  /// Stops a run behind its second frame; its exit code.
  int stopped_run() {
    std::filesystem::remove_all(path("stopped"));
    Program program(path(""), {"run", "case.toml", "-o", "stopped"});
    for (int tries = 0; tries < 20000; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (std::filesystem::exists(path("stopped/planes/section_000001.vti"))) break;
    }
    program.send(SIGINT);
    return program.wait().code;
  }
  nlohmann::json column(nlohmann::json const& summary, std::size_t gauge,
                        std::string const& name) const {
    return summary.at("gauges").at(gauge).at("columns").at(name);
  }
};

TEST_F(DerivedMeasures, AreThereAtTheEndOfARun) {
  CommandResult const run = call({"run", "case.toml", "-o", "result"});
  ASSERT_EQ(run.code, 0) << run.err;
  auto const summary = nlohmann::json::parse(bytes_of(path("result/gauges.json")));
  auto const decay = summary.at("gauges").at(0).at("decay");
  EXPECT_EQ(decay.at("points"), 6);
  EXPECT_LT(decay.at("exponent").get<double>(), -0.3) << "weaker farther away";
  EXPECT_LT(column(summary, 0, "below[1] pressure").at("arrival").get<double>(),
            column(summary, 0, "below[6] pressure").at("arrival").get<double>());
  EXPECT_TRUE(column(summary, 0, "below[6] pressure").at("duration").is_null()) << "still above";
  EXPECT_GT(column(summary, 1, "crater depth").at("largest").get<double>(), 0.04);
  EXPECT_GT(column(summary, 1, "crater volume").at("largest").get<double>(), 0.08 * 0.04);
  EXPECT_NEAR(column(summary, 2, "ground height").at("first").get<double>(), 0.3, 0.001);
  EXPECT_GT(column(summary, 3, "fireball radius").at("largest").get<double>(),
            column(summary, 3, "fireball radius").at("first").get<double>());
  EXPECT_GT(column(summary, 4, "surface rise").at("largest").get<double>(), 0.0);
  EXPECT_NEAR(column(summary, 5, "hottest max").at("largest").get<double>(), 20e6 / 0.4 / 1000.0,
              1.0);
  for (int frame = 0; frame < 5; ++frame)
    EXPECT_TRUE(std::filesystem::exists(
        path("result/planes/section_00000" + std::to_string(frame) + ".vti")));
  EXPECT_FALSE(std::filesystem::exists(path("result/planes/section_000005.vti")));
  std::string const collection = bytes_of(path("result/planes/section.pvd"));
  EXPECT_NE(collection.find("file=\"section_000004.vti\""), std::string::npos);
}

// Header and numbers of the grid belong together: 31 x 31 points of 4 + 4 + 4 + 12 + 1 bytes.
TEST_F(DerivedMeasures, PlanesHoldTheirGrid) {
  ASSERT_EQ(call({"run", "case.toml", "-o", "result"}).code, 0);
  std::string const file = bytes_of(path("result/planes/section_000000.vti"));
  EXPECT_NE(file.find("WholeExtent=\"0 30 0 30 0 0\" Origin=\"-0.3 -0.3 0\""), std::string::npos);
  std::size_t const data = file.find('_', file.find("<AppendedData")) + 1;
  std::size_t const end = file.find("\n</AppendedData>", data);
  EXPECT_EQ(end - data, 961U * 25U + 5U * 8U);
  auto const valid = file.substr(end - 961, 961);
  EXPECT_EQ(valid[0], 1) << "in the ground";
  EXPECT_EQ(valid[960], 0) << "in the open";
}

TEST_F(DerivedMeasures, SurfacesAreDrawnFromTheFrames) {
  ASSERT_EQ(call({"run", "case.toml", "-o", "result"}).code, 0);
  CommandResult const last = call({"surface", "result"});
  EXPECT_EQ(last.code, 0) << last.err;
  EXPECT_EQ(last.out, "result/surfaces/surface_000004.vtp\nresult/surfaces/surface.pvd\n");
  CommandResult const all = call({"surface", "result", "--all", "--material", "gas"});
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_TRUE(std::filesystem::exists(path("result/surfaces/gas_000000.vtp")));
  std::string const file = bytes_of(path("result/surfaces/gas_000000.vtp"));
  EXPECT_NE(file.find("Normals=\"normal\""), std::string::npos);
  EXPECT_EQ(file.find("NumberOfLines=\"0\""), std::string::npos) << "lines in 2D";
  EXPECT_EQ(call({"surface", "result", "--frame", "9"}).code, 2);
  CommandResult const unknown = call({"surface", "result", "--material", "gass"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("did you mean \"gas\"?"), std::string::npos) << unknown.err;
  EXPECT_EQ(call({"surface", "nowhere"}).code, 2);
  EXPECT_EQ(call({"run", "case.toml", "-o", "result", "--force"}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("result/surfaces/gas_000000.vtp")))
      << "surfaces of the frames that were replaced";
}

// A signal makes the run save its state; going on gives the files of a run in one piece.
TEST_F(DerivedMeasures, AreTheSameAfterAStop) {
  ASSERT_EQ(call({"run", "case.toml", "-o", "straight"}).code, 0);
  int code = 0;
  for (int runs = 0; runs < 10 && code == 0; ++runs) code = stopped_run();
  ASSERT_EQ(code, 130) << "each run was over before its signal came";
  ASSERT_EQ(call({"resume", "stopped"}).code, 0);
  for (auto const& entry : std::filesystem::recursive_directory_iterator(path("straight"))) {
    std::string const name = std::filesystem::relative(entry.path(), path("straight")).string();
    bool const of_the_clock =
        name == "manifest.json" || name == "status.json" || name == "report.html";
    if (!entry.is_regular_file() || of_the_clock || name.starts_with("checkpoints")) continue;
    EXPECT_TRUE(bytes_of(entry.path()) == bytes_of(path("stopped/" + name))) << name;
  }
}

}  // namespace
}  // namespace moraine
