// `moraine run`: the files that it promises, exit codes, signals.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "end_to_end/small_case.hpp"
#include "output/pvd_collection.hpp"
#include "output/sha256.hpp"
#include "output/table_csv.hpp"
#include "output/vtp_reader.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class RunCommand : public ScratchFolder {
 protected:
  CommandResult run(std::string const& text) {
    write(path("case.toml"), text);
    return moraine_command(path(""), {"run", "case.toml", "-o", "result"});
  }
  nlohmann::json manifest() const {
    return nlohmann::json::parse(bytes_of(path("result/manifest.json")));
  }
  /// Everything in the folder, with what is in it.
  std::map<std::string, std::string> everything() const {
    std::map<std::string, std::string> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(path("")))
      files[entry.path().string()] = entry.is_regular_file() ? bytes_of(entry.path()) : "";
    for (char const* const mine : {"out", "err"}) files.erase(path(mine).string());
    return files;
  }
};

/// Each time is the first one of a step at or after a multiple of the interval: one row for each
/// multiple, and none more than a step late.
void expect_times(std::vector<double> const& times, double interval, double end, double step) {
  auto const count = static_cast<std::size_t>(std::lround(end / interval)) + 1;
  ASSERT_EQ(times.size(), count);
  for (std::size_t k = 0; k < count; ++k) {
    double const due = interval * static_cast<double>(k);
    EXPECT_GE(times[k], due * (1.0 - 1e-12));
    EXPECT_LT(times[k], due + step);
  }
}

TEST_F(RunCommand, WritesWhatItPromises) {
  CommandResult const result = run(small_case());
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("small dam"), std::string::npos);
  EXPECT_NE(result.out.find("end time reached: time 0.02 s"), std::string::npos) << result.out;

  double const step = 2e-4;  // s, longer than the steps of this case: 0.2 * 0.03 m / 20 m/s = 3e-4
  Table const sums = read_table_csv(path("result/sums.csv"));
  expect_times(*sums.find("time"), 0.004, 0.02, step);
  Table const gauges = read_table_csv(path("result/gauges.csv"));
  expect_times(*gauges.find("time"), 0.002, 0.02, step);
  for (char const* const column : {"foot pressure", "foot density", "foot specific_energy",
                                   "foot velocity_x", "foot velocity_y", "tip front"})
    ASSERT_NE(gauges.find(column), nullptr) << column;
  EXPECT_GT(gauges.find("foot pressure")->back(), 500.0) << "rho g h is 2900 Pa";
  EXPECT_GT(gauges.find("tip front")->back(), 0.19) << "it flows along +x";
  for (double const mass : *sums.find("mass")) EXPECT_NEAR(mass, 60.0, 1e-9);
  for (double const lost : *sums.find("lost_particles")) EXPECT_EQ(lost, 0.0);

  auto const frames = read_pvd(path("result/particles.pvd"));
  std::vector<double> const due{0.0, 0.005, 0.0075, 0.01, 0.015, 0.02};
  ASSERT_EQ(frames.size(), due.size());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    EXPECT_GE(frames[k].time, due[k]);
    EXPECT_LT(frames[k].time, due[k] + step);
    ParticleFrame const frame = read_vtp(path("result") / frames[k].file);
    EXPECT_EQ(frame.time, frames[k].time);
    EXPECT_EQ(frame.size, 150u);
  }
  std::size_t files = 0;
  for (auto const& file : std::filesystem::directory_iterator(path("result/frames")))
    files += file.exists() ? 1 : 0;
  EXPECT_EQ(files, frames.size()) << "the collection lists all frames";
  EXPECT_EQ(read_vtp(path("result/walls.vtp")).size, 336u);
  EXPECT_FALSE(std::filesystem::exists(path("result/bad")));
}

// Into a file, progress is whole lines: one at each tenth, no bar that is redrawn.
TEST_F(RunCommand, LogsProgressInLines) {
  CommandResult const result = run(small_case());
  ASSERT_EQ(result.code, 0);
  for (char const c : {'\r', '\x1b'}) EXPECT_EQ(result.err.find(c), std::string::npos);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 10) << result.err;
  EXPECT_NE(result.err.find(" 50 %  t = "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("100 %  t = 20.00 ms"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("(sound and viscosity)"), std::string::npos) << result.err;
}

TEST_F(RunCommand, ManifestSaysHowItWas) {
  ASSERT_EQ(run(small_case()).code, 0);
  auto const json = manifest();
  EXPECT_EQ(json.at("program"), "moraine");
  EXPECT_FALSE(json.at("git_revision").get<std::string>().empty());
  for (char const* const key : {"version", "compiler", "compiler_flags", "simd"}) {
    EXPECT_FALSE(json.at(key).get<std::string>().empty()) << key;
    EXPECT_NE(json.at(key), "unknown") << key;
  }
  EXPECT_EQ(json.at("precision"), "mixed");
  EXPECT_EQ(json.at("threads"), 2);
  EXPECT_EQ(json.at("case_file"), "case.toml");
  EXPECT_EQ(json.at("case_sha256"), sha256(small_case()));
  EXPECT_EQ(json.at("particles_at_start"), 150 + 336);
  EXPECT_EQ(json.at("state"), "ended");
  auto const& end = json.at("end");
  EXPECT_EQ(end.at("reason"), "end time reached");
  EXPECT_EQ(end.at("simulated_time_s"), 0.02);
  EXPECT_GT(end.at("steps"), 60);
  EXPECT_EQ(end.at("particles"), 150 + 336);
  EXPECT_GT(end.at("wall_time_s"), 0.0);
}

// The used case is the same case: it reads back to the same text and runs to the same bits.
TEST_F(RunCommand, UsedCaseIsTheSameCase) {
  ASSERT_EQ(run(small_case()).code, 0);
  std::string const used = bytes_of(path("result/case.used.toml"));
  EXPECT_EQ(used_case(read_case(path("result/case.used.toml"))), used);
  EXPECT_EQ(used_case(read_case(path("case.toml"))), used);
  ASSERT_EQ(moraine_command(path(""), {"run", "result/case.used.toml", "-o", "again"}).code, 0);
  for (char const* const file : {"sums.csv", "gauges.csv", "frames/particles_000005.vtp"})
    EXPECT_TRUE(bytes_of(path("again") / file) == bytes_of(path("result") / file)) << file;
}

TEST_F(RunCommand, BadCaseIsRefusedAndWritesNothing) {
  ASSERT_EQ(run(small_case()).code, 0);
  std::string text = small_case("end = -1.0, curant = 0.2");
  write(path("bad.toml"), text.replace(text.find("\"tait\""), 6, "\"tiat\""));
  auto const before = everything();
  CommandResult const result = moraine_command(path(""), {"run", "bad.toml", "-o", "result"});
  EXPECT_EQ(result.code, 2);
  for (char const* const part : {"bad.toml:5:", "time.end", "curant", "courant", "tiat", "tait"})
    EXPECT_NE(result.err.find(part), std::string::npos) << part << " in\n" << result.err;
  EXPECT_EQ(moraine_command(path(""), {"run", "bad.toml"}).code, 2);
  EXPECT_EQ(moraine_command(path(""), {"run", "missing.toml"}).code, 2);
  EXPECT_TRUE(everything() == before);
}

// Steps seven times as long as sound allows.
TEST_F(RunCommand, UnstableRunNamesTheParticle) {
  CommandResult const result = run(small_case("end = 1.0, fixed_step = 0.004"));
  EXPECT_EQ(result.code, 3);
  std::smatch found;
  std::regex const message(R"(unstable: particle (\d+) \(water\) at \(([^,]+), ([^)]+)\) m: .+; )"
                           R"(time .+ s, step \d+, time step 0.004 s limited by fixed step)");
  ASSERT_TRUE(std::regex_search(result.err, found, message)) << result.err;
  ParticleFrame const frame = read_vtp(path("result/bad/frame.vtp"));
  auto const& ids = frame.find("id")->values;
  auto const at = std::find(ids.begin(), ids.end(), std::stod(found[1]));
  ASSERT_NE(at, ids.end());
  auto const k = static_cast<std::size_t>(at - ids.begin());
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double const place = std::stod(found[2 + axis]);
    // Six digits in the message, single precision in the frame.
    EXPECT_NEAR(frame.points.values[3 * k + axis], place, 1e-5 * std::fabs(place));
  }
  // The frame flags whoever is named, and no more than are counted: guard 3 is that of motion.
  auto const& flags = frame.find("guard")->values;
  EXPECT_EQ(flags[k], 3.0);
  std::smatch more;
  std::regex const also("\n  also particle ");
  std::regex const counted(R"(\n  and (\d+) more)");
  auto told = 1 + std::distance(std::sregex_iterator(result.err.begin(), result.err.end(), also),
                                std::sregex_iterator());
  if (std::regex_search(result.err, more, counted)) told += std::stol(more[1]);
  EXPECT_EQ(std::count(flags.begin(), flags.end(), 3.0), told);
  EXPECT_EQ(std::count(flags.begin(), flags.end(), 0.0) + told, 150);
  for (char const* const part : {"guard: motion", "last time steps: ", "last good state: ",
                                 "bad/frame.vtp", "moraine resume result"})
    EXPECT_NE(result.err.find(part), std::string::npos) << part << " in\n" << result.err;
  EXPECT_EQ(read_vtp(path("result/bad/walls.vtp")).size, 336u);
  auto const end = manifest().at("end");
  EXPECT_NE(end.at("reason").get<std::string>().find("unstable: particle " + found[1].str()),
            std::string::npos);
  for (PvdEntry const& frame_entry : read_pvd(path("result/particles.pvd")))
    EXPECT_EQ(frame_entry.file.find("bad"), std::string::npos) << "apart from good frames";
}

class SignalledRun : public RunCommand, public testing::WithParamInterface<int> {};

TEST_P(SignalledRun, WritesItsLastState) {
  write(path("case.toml"), small_case("end = 1e6"));
  Program program(path(""), {"run", "case.toml", "-o", "result"});
  auto const rows = [&] {
    std::string const text = bytes_of(path("result/sums.csv"));
    return std::count(text.begin(), text.end(), '\n');
  };
  for (int tries = 0; rows() < 5 && tries < 3000; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_GE(rows(), 5);
  program.send(GetParam());
  CommandResult const result = program.wait();
  EXPECT_EQ(result.code, 130) << result.err;
  auto const end = manifest().at("end");
  EXPECT_EQ(end.at("reason"), "interrupted");
  double const time = end.at("simulated_time_s");
  EXPECT_GT(time, 0.012);
  EXPECT_LT(time, 1e6);
  PvdEntry const last = read_pvd(path("result/particles.pvd")).back();
  EXPECT_EQ(last.time, time);
  ParticleFrame const frame = read_vtp(path("result") / last.file);
  EXPECT_EQ(frame.time, time);
  EXPECT_EQ(frame.size, 150u);
}

INSTANTIATE_TEST_SUITE_P(By, SignalledRun, testing::Values(SIGINT, SIGTERM),
                         [](auto const& by) { return by.param == SIGINT ? "SIGINT" : "SIGTERM"; });

}  // namespace
}  // namespace moraine
