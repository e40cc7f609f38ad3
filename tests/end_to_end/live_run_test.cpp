// Two commands that want the same folder, folders that cannot be cleared, bodies from STL files
// that go away, checkpoints of other programs.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "base/simd.hpp"
#include "end_to_end/small_case.hpp"
#include "output/checkpoint/seal.hpp"
#include "output/run_lock.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

/// A ball of water in space, from a mesh.
constexpr char const* body_case = R"(space = { dimension = 3 }
resolution.spacing = 0.1
time = { end = "1 s", fixed_step = "1 us" }
output = { frames = "1 ms", checkpoints = "10 ms" }
material.water = { eos = "tait", reference_sound_speed = 20.0 }
[[region]]
name = "wedge"
material = "water"
box = { min = [2, 0, 0], max = [3, 1, 1] }
plus = [{ stl = { file = "parts/wedge.stl", units = "m" } }]
)";

std::string wedge_stl() {
  std::string const corners[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  int const faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string text = "solid wedge\n";
  for (auto const& face : faces) {
    text += "facet normal 0 0 0 outer loop";
    for (int const corner : face) text += " vertex " + corners[corner];
    text += " endloop endfacet\n";
  }
  return text + "endsolid\n";
}

class LiveRun : public ScratchFolder {
 protected:
  CommandResult command(std::vector<std::string> const& arguments) const {
    return moraine_command(path(""), arguments);
  }
  /// Starts a command and waits until its run has two checkpoints.
  Program start(std::vector<std::string> const& arguments) const {
    std::filesystem::create_directories(path("live"));
    Program program(path("live"), arguments);
    for (int tries = 0; tries < 6000 && checkpoints() < 2; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return program;
  }
  std::size_t checkpoints() const {
    std::error_code none;
    std::size_t count = 0;
    for (auto const& entry : std::filesystem::directory_iterator(path("results/checkpoints"), none))
      count += entry.path().extension() == ".h5" ? 1 : 0;
    return count;
  }
  std::filesystem::path newest_checkpoint() const {
    std::filesystem::path newest;
    for (auto const& entry : std::filesystem::directory_iterator(path("results/checkpoints")))
      if (entry.path().extension() == ".h5") newest = std::max(newest, entry.path());
    return newest;
  }
  /// Goes on with the run until it has written its beginning, then stops it.
  CommandResult resume_for_a_moment() const {
    std::string const before = bytes_of(path("results/manifest.json"));
    Program resumed(path(""), {"resume", "results"});
    for (int tries = 0; tries < 6000 && bytes_of(path("results/manifest.json")) == before; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    resumed.send(SIGINT);
    return resumed.wait();
  }
  void write_body_case() const {
    std::filesystem::create_directories(path("parts"));
    write(path("parts/wedge.stl"), wedge_stl());
    write(path("case.toml"), body_case);
  }
};

TEST_F(LiveRun, IsNotDisturbed) {
  std::string text = small_case("end = 1000.0");
  text.replace(text.find("frame_times"), 0, "checkpoints = \"20 ms\", ");
  write(path("case.toml"), text);
  Program program = start({"run", "../case.toml", "-o", "../results"});
  for (auto const& arguments : {std::vector<std::string>{"resume", "results"},
                                {"run", "case.toml", "-o", "results"},
                                {"run", "case.toml", "-o", "results", "--force"}}) {
    CommandResult const refused = command(arguments);
    EXPECT_EQ(refused.code, 2) << arguments.back();
    EXPECT_NE(refused.err.find("\"results\" belongs to a run that is still going on"),
              std::string::npos)
        << refused.err;
  }
  program.send(SIGKILL);
  EXPECT_EQ(program.wait().code, 128 + SIGKILL) << "it went on until now";
  EXPECT_FALSE(RunLock::is_held(path("results"))) << "killing gives the folder back";
}

TEST_F(LiveRun, LockIsHeldOnce) {
  EXPECT_FALSE(RunLock::is_held(path("")));
  EXPECT_FALSE(std::filesystem::exists(path("lock"))) << "asking makes no file";
  {
    auto const lock = RunLock::take(path(""));
    ASSERT_TRUE(lock);
    EXPECT_TRUE(RunLock::is_held(path("")));
    EXPECT_FALSE(RunLock::take(path("")));
  }
  EXPECT_TRUE(RunLock::take(path("")));
}

// Folders in place of files: they cannot be removed or replaced, whoever tries.
TEST_F(LiveRun, WhatCannotBeClearedOrDrawnIsAFailureOfWriting) {
  write(path("case.toml"), small_case("end = 1e-3"));
  ASSERT_EQ(command({"run", "case.toml", "-o", "results"}).code, 0);
  for (std::string const name : {"bad/frame.vtp", "stop", "frames/particles_000007.vtp"}) {
    std::filesystem::create_directories(path("results/" + name + "/full"));
    CommandResult const result = command({"run", "case.toml", "-o", "results", "--force"});
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_NE(result.err.find("cannot remove 'results/" + name + "'"), std::string::npos)
        << result.err;
    std::filesystem::remove_all(path("results/" + name));
  }
  ASSERT_EQ(command({"run", "case.toml", "-o", "results", "--force"}).code, 0);
  write(path("results/plots"), "a file");
  CommandResult const plot = command({"plot", "results"});
  EXPECT_EQ(plot.code, 4) << plot.err;
  EXPECT_NE(plot.err.find("cannot write picture"), std::string::npos) << plot.err;
}

TEST_F(LiveRun, KeepsItsBodies) {
  write_body_case();
  Program program = start({"run", "../case.toml", "-o", "../results"});
  program.send(SIGINT);
  CommandResult const stopped = program.wait();
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  std::filesystem::path kept;
  for (auto const& entry : std::filesystem::directory_iterator(path("results/bodies")))
    kept = entry.path();
  EXPECT_EQ(bytes_of(kept), wedge_stl());
  EXPECT_NE(bytes_of(path("results/case.used.toml")).find("\"bodies/" + kept.filename().string()),
            std::string::npos);

  std::string const changed = wedge_stl() + "solid more\nendsolid\n";
  write(kept, changed);
  CommandResult const refused = command({"resume", "results"});
  EXPECT_EQ(refused.code, 2) << refused.err;
  EXPECT_NE(refused.err.find("has changed since the run began"), std::string::npos) << refused.err;
  write(kept, wedge_stl());

  // The file that the case named is not needed any more.
  std::filesystem::remove_all(path("parts"));
  CommandResult const resumed = resume_for_a_moment();
  EXPECT_EQ(resumed.code, 130) << resumed.err;
  EXPECT_EQ(command({"check", "results/case.used.toml"}).code, 0);
}

TEST_F(LiveRun, SaysThatAnotherProgramSavedIt) {
  write(path("case.toml"), small_case("end = 1000.0"));
  Program program(path(""), {"run", "case.toml", "-o", "results"});
  for (int tries = 0; tries < 6000 && checkpoints() < 1; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGINT);
  ASSERT_EQ(program.wait().code, 130);
  EXPECT_EQ(resume_for_a_moment().err.find("warning"), std::string::npos);
  auto const file = newest_checkpoint();
  std::string bytes = bytes_of(file);
  std::size_t const place = bytes.rfind(simd_flavour);
  ASSERT_NE(place, std::string::npos);
  bytes.replace(place, 3, "XYZ");
  seal(bytes);
  write(file, bytes);
  std::string const warning = resume_for_a_moment().err;
  EXPECT_NE(warning.find("saved by a program with XYZ"), std::string::npos) << warning;
}

}  // namespace
}  // namespace moraine
