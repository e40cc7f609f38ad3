// `moraine resume`: whatever stopped a run, its files end up as if it had never stopped.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

constexpr char const* dam_break = R"(
[space]
dimension = 2
[physics]
gravity = [0.0, -9.81]
[resolution]
spacing = 0.02
[time]
end = "0.3 s"
[output]
frames = "5 ms"
gauges = "1 ms"
checkpoints = "20 ms"
[material.water]
eos = "tait"
reference_sound_speed = 25
[[region]]
name = "column"
material = "water"
box = { min = [0, 0], max = [0.4, 0.4] }
[[wall]]
name = "tank"
container = { min = [0, 0], max = [1, 0.6] }
open = ["y+"]
[[gauge]]
name = "wall"
position = [0.98, 0.05]
)";

class ResumeCommand : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("case.toml"), dam_break);
  }
  CommandResult run(std::string const& folder) {
    return moraine_command(path(""), {"run", "case.toml", "-o", folder});
  }
  CommandResult resume(std::string const& folder) {
    return moraine_command(path(""), {"resume", folder});
  }
  /// All results with their content. Manifest, status and report tell of wall time; checkpoints
  /// come and go.
  std::map<std::string, std::string> results(std::string const& folder) const {
    std::map<std::string, std::string> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(path(folder))) {
      std::string const name = std::filesystem::relative(entry.path(), path(folder)).string();
      bool const of_wall_time =
          name == "manifest.json" || name == "status.json" || name == "report.html";
      if (entry.is_regular_file() && !of_wall_time && !name.starts_with("checkpoints"))
        files[name] = bytes_of(entry.path());
    }
    return files;
  }
  void expect_same(std::string const& a, std::string const& b) const {
    auto const first = results(a);
    auto const second = results(b);
    for (auto const& [name, bytes] : first) {
      auto const found = second.find(name);
      if (found == second.end())
        ADD_FAILURE() << name << " is missing";
      else
        EXPECT_TRUE(found->second == bytes) << name << " differs";
    }
    EXPECT_EQ(first.size(), second.size());
    EXPECT_GT(first.size(), 50U) << "frames of every 5 ms";
  }
  std::vector<std::filesystem::path> checkpoints(std::string const& folder) const {
    std::vector<std::filesystem::path> found;
    for (auto const& entry : std::filesystem::directory_iterator(path(folder) / "checkpoints"))
      found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
  }
  /// Starts a run or goes on with it, waits until it has this many checkpoints, and some more.
  Program started(std::vector<std::string> const& arguments, std::string const& folder,
                  std::size_t wanted, std::chrono::milliseconds more = {}) {
    Program program(path(""), arguments);
    auto const count = [&] {
      std::error_code none;
      std::filesystem::directory_iterator files(path(folder) / "checkpoints", none);
      return static_cast<std::size_t>(std::count_if(
          begin(files), end(files), [](auto const& e) { return e.path().extension() == ".h5"; }));
    };
    for (int tries = 0; tries < 6000 && count() < wanted; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(more);
    return program;
  }
};

TEST_F(ResumeCommand, GoesOnAfterASignalAsIfNothingHadHappened) {
  ASSERT_EQ(run("straight").code, 0);
  for (int const signal : {SIGINT, SIGTERM}) {
    std::string const folder = signal == SIGINT ? "by_int" : "by_term";
    Program program = started({"run", "case.toml", "-o", folder}, folder, 2);
    program.send(signal);
    CommandResult const stopped = program.wait();
    ASSERT_EQ(stopped.code, 130) << "over before the signal came";
    EXPECT_NE(stopped.out.find("moraine resume " + folder), std::string::npos) << stopped.out;
    CommandResult const resumed = resume(folder);
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_NE(resumed.out.find("goes on at time"), std::string::npos);
    expect_same("straight", folder);
  }
}

TEST_F(ResumeCommand, GoesOnAfterAStopFile) {
  ASSERT_EQ(run("straight").code, 0);
  Program program = started({"run", "case.toml", "-o", "stopped"}, "stopped", 2);
  write(path("stopped/stop"), "");
  CommandResult const stopped = program.wait();
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_FALSE(std::filesystem::exists(path("stopped/stop"))) << "the request is answered";
  EXPECT_EQ(resume("stopped").code, 0);
  expect_same("straight", "stopped");
}

// MORAINE_KILLS sets the number; the default keeps the tests short.
TEST_F(ResumeCommand, LosesNothingWhenKilledAtAnyMoment) {
  ASSERT_EQ(run("straight").code, 0);
  char const* const asked = std::getenv("MORAINE_KILLS");
  int const wanted = asked != nullptr ? std::atoi(asked) : 6;
  std::mt19937 random(static_cast<unsigned>(wanted));
  std::uniform_int_distribution<int> wait_ms(0, 250);
  int killed = 0;
  for (int round = 0; killed < wanted; ++round) {
    std::filesystem::remove_all(path("killed"));
    std::vector<std::string> arguments{"run", "case.toml", "-o", "killed"};
    for (bool over = false; !over;) {
      Program program = started(arguments, "killed", 1, std::chrono::milliseconds(wait_ms(random)));
      if (killed < wanted) program.send(SIGKILL);
      CommandResult const result = program.wait();
      over = result.code == 0;
      if (!over) ++killed;
      EXPECT_TRUE(over || result.code == 128 + SIGKILL) << result.code << ' ' << result.err;
      if (!over && result.code != 128 + SIGKILL) return;
      arguments = {"resume", "killed"};
    }
    expect_same("straight", "killed");
    ASSERT_LT(round, 10 * wanted) << "runs are over before they are killed";
  }
}

TEST_F(ResumeCommand, PassesOverADamagedCheckpoint) {
  ASSERT_EQ(run("straight").code, 0);
  Program program = started({"run", "case.toml", "-o", "damaged"}, "damaged", 2);
  program.send(SIGKILL);
  ASSERT_EQ(program.wait().code, 128 + SIGKILL);
  auto files = checkpoints("damaged");
  std::erase_if(files, [](auto const& file) { return file.extension() == ".tmp"; });
  ASSERT_EQ(files.size(), 2U);
  auto const newest = files.back();
  std::string bytes = bytes_of(newest);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  write(newest, bytes);
  CommandResult const resumed = resume("damaged");
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("passed over: "), std::string::npos);
  expect_same("straight", "damaged");
}

// A limit on the size of files stands for a full disk; frames, tables or checkpoints meet it.
TEST_F(ResumeCommand, SurvivesADiskThatFillsUp) {
  ASSERT_EQ(run("straight").code, 0);
  for (int const kilobytes : {2, 40, 90}) {
    std::string const folder = "full_" + std::to_string(kilobytes);
    Program program(path(""), {"run", "case.toml", "-o", folder},
                    static_cast<rlim_t>(kilobytes) * 1024);
    CommandResult const full = program.wait();
    EXPECT_EQ(full.code, 4) << full.err;
    EXPECT_NE(full.err.find("File too large"), std::string::npos) << full.err;
    CommandResult const resumed = resume(folder);
    if (full.err.find("moraine resume") == std::string::npos) {
      EXPECT_EQ(resumed.code, 2) << "nothing was saved";
      continue;
    }
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    expect_same("straight", folder);
  }
}

TEST_F(ResumeCommand, LeavesAFinishedRunAsItIs) {
  ASSERT_EQ(run("done").code, 0);
  auto const before = results("done");
  auto const written = std::filesystem::last_write_time(path("done/manifest.json"));
  CommandResult const result = resume("done");
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.out.find("nothing left to do"), std::string::npos) << result.out;
  EXPECT_TRUE(results("done") == before);
  EXPECT_EQ(std::filesystem::last_write_time(path("done/manifest.json")), written);
}

TEST_F(ResumeCommand, SaysWhyItCannot) {
  auto const refused = [&](std::string const& folder, std::string const& why) {
    CommandResult const result = resume(folder);
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
  };
  refused("nowhere", "is not a folder");
  std::filesystem::create_directories(path("empty"));
  refused("empty", "holds no run");
  ASSERT_EQ(run("bare").code, 0);
  std::filesystem::remove_all(path("bare/checkpoints"));
  refused("bare", "has no whole checkpoint");
}

TEST_F(ResumeCommand, AnotherRunIsNeverOverwritten) {
  ASSERT_EQ(run("first").code, 0);
  auto const before = results("first");
  CommandResult const refused = run("first");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  EXPECT_TRUE(results("first") == before);
  EXPECT_EQ(moraine_command(path(""), {"run", "case.toml", "-o", "first", "--force"}).code, 0);
  EXPECT_TRUE(results("first") == before) << "the same case gives the same files";
}

}  // namespace
}  // namespace moraine
