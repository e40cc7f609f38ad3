// What a run leaves in its folder: last rows, no pictures of earlier runs, time under labels.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "output/run_folder.hpp"
#include "output/run_recorder.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class RecorderFolder : public ScratchFolder {
 protected:
  /// A run of ten fixed steps of 1 ms with rows each `interval`, ended after `steps`.
  void run(std::string const& interval, int steps) {
    write(path("case.toml"),
          "[space]\ndimension = 1\n[resolution]\nspacing = 0.1\n[time]\n"
          "end = 0.01\nfixed_step = 0.001\n[output]\ngauges = " +
              interval + "\nsums = " + interval +
              "\n[material.water]\neos = \"tait\"\nreference_sound_speed = 10\n"
              "[[region]]\nname = \"pool\"\nmaterial = \"water\"\n"
              "box = { min = [0], max = [1] }\n"
              "[[gauge]]\nname = \"middle\"\nposition = [0.5]\n");
    Case const c = read_case(path("case.toml"));
    Simulation simulation(build_model(c));
    make_run_folder(path("out"));
    RunRecorder recorder(c, simulation, path("out"), 1);
    for (int step = 0; step < steps; ++step) {
      simulation.advance();
      recorder.tell(simulation);
    }
    recorder.finish(simulation, "test", 0.0);
    for (TimerEntry const& entry : recorder.timers().entries()) calls_.push_back(entry.calls);
  }

  std::vector<double> times(std::string const& table) const {
    return *read_table_csv(path("out/" + table)).find("time");
  }

  std::vector<std::uint64_t> calls_;
};

TEST_F(RecorderFolder, WritesTheLastRowsOnce) {
  for (auto const& [interval, steps, rows] :
       {std::tuple("0.004", 10, 4U), std::tuple("0.005", 10, 3U), std::tuple("0", 3, 4U),
        std::tuple("0.004", 6, 3U)}) {
    run(interval, steps);
    for (char const* table : {"gauges.csv", "sums.csv"}) {
      auto const written = times(table);
      ASSERT_EQ(written.size(), rows) << table << ' ' << interval;
      EXPECT_NEAR(written.back(), 0.001 * steps, 1e-15);
      EXPECT_TRUE(std::is_sorted(written.begin(), written.end(), std::less_equal<>()));
    }
  }
}

TEST_F(RecorderFolder, TimesWhatItWrites) {
  run("0", 5);
  EXPECT_EQ(calls_, (std::vector<std::uint64_t>{2, 6, 6}));  // frames, gauges, sums
}

TEST_F(RecorderFolder, ClearsItsOwnPicturesOnly) {
  std::vector<std::string> const ours{"histories.svg", "sums.png", "pressure_particles_000012.png",
                                      "velocity_x_particles_000000.png"};
  std::vector<std::string> const others{"sums.txt", "my_sums.png", "pressure_particles_12.png",
                                        "histories.svg.bak", "particles_000012.png"};
  std::filesystem::create_directories(path("out/plots"));
  for (auto const& list : {ours, others})
    for (auto const& name : list) write(path("out/plots/" + name), "x");
  run("0", 1);
  for (auto const& name : ours) EXPECT_FALSE(std::filesystem::exists(path("out/plots/" + name)));
  for (auto const& name : others)
    EXPECT_TRUE(std::filesystem::exists(path("out/plots/" + name))) << name;
}

}  // namespace
}  // namespace moraine
