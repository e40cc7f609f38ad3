#include "output/run_recorder.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "output/run_folder.hpp"
#include "output/vtp_reader.hpp"
#include "scratch_folder.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

/// The times among these at which something is due.
std::vector<double> met(Schedule schedule, std::vector<double> const& times) {
  std::vector<double> due;
  for (double const time : times)
    if (schedule.due(time)) due.push_back(time);
  return due;
}

using Times = std::vector<double>;

TEST(Schedule, MeetsEachMultipleAtTheFirstStepBehindIt) {
  Times const steps{0.0, 0.4, 0.9, 1.1, 1.9, 2.0, 2.1, 2.9, 3.3};
  EXPECT_EQ(met(Schedule(1.0, {}, false), steps), (Times{0.0, 1.1, 2.0, 3.3}));
}

TEST(Schedule, MeetsSeveralMultiplesAtOnceWithOne) {
  EXPECT_EQ(met(Schedule(1.0, {}, false), {0.0, 3.5, 3.6, 4.0}), (Times{0.0, 3.5, 4.0}));
}

TEST(Schedule, TakesARoundingErrorForTheTime) {
  double const early = 0.3 - 1e-16;
  EXPECT_EQ(met(Schedule(0.1, {}, false), {0.0, 0.1, 0.2, early, 0.35}),
            (Times{0.0, 0.1, 0.2, early}));
}

TEST(Schedule, MeetsListedTimesInAnyOrder) {
  EXPECT_EQ(met(Schedule(0.0, {2.5, 0.5}, false), {0.0, 0.4, 0.6, 1.0, 2.5, 3.0}),
            (Times{0.6, 2.5}));
  EXPECT_EQ(met(Schedule(2.0, {0.5}, false), {0.0, 0.6, 1.0, 2.0}), (Times{0.0, 0.6, 2.0}));
}

TEST(Schedule, MeetsEveryStepOrNone) {
  EXPECT_EQ(met(Schedule(0.0, {}, true), {0.0, 0.1, 0.7}), (Times{0.0, 0.1, 0.7}));
  EXPECT_EQ(met(Schedule(0.0, {}, false), {0.0, 0.1, 0.7}), Times{});
}

class Recorder : public ScratchFolder {
 protected:
  /// A few particles in a container, or without walls, and what their output says.
  Case small(std::string const& output, bool wall = true) {
    write(path("case.toml"), R"(space = { dimension = 1, domain = { min = [-1.0], max = [2.0] } }
resolution.spacing = 0.1
time = { end = 1.0, fixed_step = 0.001 }
material.water = { eos = "tait", reference_sound_speed = 10.0 }
output = { )" + output + R"( }
[[region]]
name = "water"
material = "water"
box = { min = [0.0], max = [1.0] }
[[gauge]]
name = "middle"
position = [0.5]
)" + (wall ? "[[wall]]\nname = \"tank\"\ncontainer = { min = [0.0], max = [1.0] }\n" : ""));
    return read_case(path("case.toml"));
  }
  std::filesystem::path folder() const { return path("result"); }
  std::size_t rows(std::string const& table) const {
    return read_table_csv(folder() / table).rows();
  }
  std::size_t frames() const { return read_pvd(folder() / "particles.pvd").size(); }
};

TEST_F(Recorder, WritesTheStartAtOnce) {
  Case const c = small("");
  Simulation const simulation(build_model(c));
  make_run_folder(folder());
  RunRecorder const recorder(c, simulation, folder(), 3);
  EXPECT_EQ(rows("gauges.csv"), 1u);
  EXPECT_EQ(rows("sums.csv"), 1u);
  EXPECT_EQ(frames(), 1u);
  EXPECT_TRUE(std::filesystem::exists(folder() / "case.used.toml"));
  EXPECT_EQ(read_vtp(folder() / "walls.vtp").size, simulation.particles().range(Kind::wall).size());
  auto const manifest = nlohmann::json::parse(bytes_of(folder() / "manifest.json"));
  EXPECT_EQ(manifest.at("state"), "running");
  EXPECT_EQ(manifest.at("threads"), 3);
}

// Intervals of zero: gauges and sums of every step, the first and the last frame.
TEST_F(Recorder, WritesEveryStepWhereNoIntervalIsGiven) {
  Case const c = small("");
  Simulation simulation(build_model(c));
  make_run_folder(folder());
  RunRecorder recorder(c, simulation, folder(), 1);
  for (int step = 0; step < 5; ++step) {
    simulation.advance();
    recorder.tell(simulation);
  }
  EXPECT_EQ(rows("gauges.csv"), 6u);
  EXPECT_EQ(rows("sums.csv"), 6u);
  EXPECT_EQ(frames(), 1u);
  recorder.finish(simulation, "enough", 2.5);
  EXPECT_EQ(frames(), 2u);
  auto const end = nlohmann::json::parse(bytes_of(folder() / "manifest.json")).at("end");
  EXPECT_EQ(end.at("reason"), "enough");
  EXPECT_EQ(end.at("wall_time_s"), 2.5);
  EXPECT_EQ(end.at("steps"), 5);
}

TEST_F(Recorder, WritesTheLastFrameOnce) {
  Case const c = small("frames = 0.001");
  Simulation simulation(build_model(c));
  make_run_folder(folder());
  RunRecorder recorder(c, simulation, folder(), 1);
  for (int step = 0; step < 3; ++step) {
    simulation.advance();
    recorder.tell(simulation);
  }
  EXPECT_EQ(frames(), 4u);
  recorder.finish(simulation, "enough", 0.0);
  EXPECT_EQ(frames(), 4u);
}

TEST_F(Recorder, SumsUpItsGaugesAndPutsEnvelopesIntoFrames) {
  Case const c = small("arrival_pressure = 1.0");
  Simulation simulation(build_model(c));
  RunRecorder recorder(c, simulation, folder(), 1);
  simulation.advance();
  recorder.tell(simulation);
  recorder.finish(simulation, "enough", 0.0);
  EXPECT_TRUE(recorder.remarks().empty());
  auto const gauge = nlohmann::json::parse(bytes_of(folder() / "gauges.json")).at("gauges").at(0);
  EXPECT_EQ(gauge.at("name"), "middle");
  EXPECT_EQ(gauge.at("seen"), true);
  EXPECT_TRUE(gauge.at("columns").at("middle pressure").at("arrival").is_null());
  auto const frame = read_vtp(folder() / "frames/particles_000001.vtp");
  for (char const* const name : {"peak_pressure", "time_of_peak", "arrival", "impulse"})
    EXPECT_NE(frame.find(name), nullptr) << name;
}

TEST_F(Recorder, KeepsABrokenStateApart) {
  Case const c = small("");
  Simulation const simulation(build_model(c));
  make_run_folder(folder());
  RunRecorder recorder(c, simulation, folder(), 1);
  EXPECT_EQ(recorder.give_up(simulation, "unstable: ...", {{3, 2}, {7, 5}}, 0.0),
            folder() / "bad/frame.vtp");
  auto const frame = read_vtp(folder() / "bad/frame.vtp");
  ASSERT_EQ(frame.size, 10u);
  for (std::size_t k = 0; k < frame.size; ++k) {
    double const id = frame.find("id")->values[k];
    EXPECT_EQ(frame.find("guard")->values[k], id == 3.0 ? 2.0 : id == 7.0 ? 5.0 : 0.0);
  }
  EXPECT_EQ(read_vtp(folder() / "bad/walls.vtp").size,
            simulation.particles().range(Kind::wall).size());
  EXPECT_EQ(frames(), 1u);
  auto const manifest = nlohmann::json::parse(bytes_of(folder() / "manifest.json"));
  EXPECT_EQ(manifest.at("end").at("reason"), "unstable: ...");
}

// A second run into the folder of a first one: nothing of the first is taken for its own, and files
// of others stay.
TEST_F(Recorder, ClearsAnEarlierRun) {
  std::filesystem::create_directories(folder() / "frames");
  std::filesystem::create_directories(folder() / "bad");
  for (char const* const name : {"frames/particles_000007.vtp", "bad/frame.vtp", "bad/walls.vtp",
                                 "walls.vtp", "notes.txt", "frames/mine.vtp"})
    write(folder() / name, "x");
  Case const c = small("", false);
  Simulation const simulation(build_model(c));
  make_run_folder(folder());
  RunRecorder const recorder(c, simulation, folder(), 1);
  for (char const* const name : {"frames/particles_000007.vtp", "bad", "walls.vtp"})
    EXPECT_FALSE(std::filesystem::exists(folder() / name)) << name;
  for (char const* const name : {"notes.txt", "frames/mine.vtp"})
    EXPECT_EQ(bytes_of(folder() / name), "x") << name;
}

}  // namespace
}  // namespace moraine
