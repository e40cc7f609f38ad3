#include "watch/screen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace moraine::watch {
namespace {

report::RunFiles half_way() {
  report::RunFiles run;
  run.name = "dam";
  run.going_on = true;
  run.status = {{"state", "running"},
                {"time_s", 0.5},
                {"end_time_s", 1.0},
                {"step", 1200},
                {"time_step_s", 4e-4},
                {"limited_by", "motion"},
                {"steps_per_second", 100.0},
                {"time_left_s", 75.0},
                {"particles", 5000},
                {"wall_time_s", 60.0},
                {"votes", {{{"reason", "sound and viscosity"}, {"steps", 1100}}}},
                {"guards", {{{"name", "speed"}, {"largest_part_of_bound", 0.123}}}}};
  run.gauges.columns = {{"time", "s"}, {"a gauge with a long name, so long that it is cut", "Pa"}};
  run.gauges.values = {{0.0, 0.5}, {0.0, 2e6}};
  run.sums.columns = {{"time", "s"}, {"kinetic_energy", "J"}};
  run.sums.values = {{0.0, 0.5}, {0.0, 3.0}};
  return run;
}

TEST(Screen, SaysHowFarARunIs) {
  std::string const text = screen_of(half_way(), {80, 24});
  for (char const* const part :
       {"dam  (running)", "[###############...............] 50 %  500.0 ms of 1.000 s  1:15 left",
        "step 1200  100 steps/s  5000 particles", "limited by motion",
        "most often by sound and viscosity", "guards: speed 12 %", "2.00 MPa", "3.00 J", "▁█"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(Screen, FitsIntoTheTerminal) {
  report::RunFiles run = half_way();
  for (int k = 0; k < 50; ++k) {
    run.gauges.columns.push_back({"x", "m"});
    run.gauges.values.push_back({0.0, 1.0});
  }
  std::istringstream lines(screen_of(run, {60, 20}));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    auto const width = std::count_if(line.begin(), line.end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    });
    EXPECT_LE(width, 60) << line;
  }
  EXPECT_LT(count, 20);
}

TEST(Screen, ShowsControlCharactersAsQuestionMarks) {
  report::RunFiles run = half_way();
  run.name = "a\x1b]0;b\x07\xc2\x9b\x7f\n\xc3\xa4";
  std::string const text = screen_of(run, {80, 24});
  EXPECT_EQ(text.substr(0, text.find('(')), "a?]0;b????\xc3\xa4  ");
}

TEST(Screen, LivesWithAnEmptyStatus) {
  report::RunFiles run;
  run.name = "young";
  EXPECT_NE(screen_of(run, {}).find("young  (stopped)"), std::string::npos);
}

}  // namespace
}  // namespace moraine::watch
