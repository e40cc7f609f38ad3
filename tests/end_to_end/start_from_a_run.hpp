// A run that has settled, and cases that start from its end.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "output/checkpoint/checkpoints.hpp"
#include "output/checkpoint/run_state.hpp"
#include "output/checkpoint/start_reader.hpp"
#include "setup/read_case.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {

/// Everything but regions, start and end.
inline std::string pool(std::string const& end, std::string const& sound_speed = "100") {
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

inline constexpr char const* water = R"([[region]]
name = "water"
material = "water"
box = { min = [0, 0], max = [0.6, 0.4] }
)";
inline constexpr char const* from_settled = "[start]\nrun = \"settled\"\n";
inline constexpr char const* charge = R"([[region]]
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
  /// All results with their content. HDF5 files, manifest, status and report hold times of
  /// the clock.
  std::map<std::string, std::string> results(std::string const& folder) const {
    std::map<std::string, std::string> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(path(folder))) {
      std::string const name = std::filesystem::relative(entry.path(), path(folder)).string();
      bool const of_the_clock = name == "manifest.json" || name == "start.h5" ||
                                name == "status.json" || name == "report.html";
      if (entry.is_regular_file() && !of_the_clock && !name.starts_with("checkpoints"))
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

}  // namespace moraine
