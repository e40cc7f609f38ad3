#include "base/timer.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace moraine {
namespace {

using namespace std::chrono_literals;

TEST(Timers, SumIntervalsPerLabel) {
  Timers timers;
  int const search = timers.add("search");
  int const forces = timers.add("forces");
  timers.record(search, 2ms);
  timers.record(search, 3ms);
  timers.record(forces, 7ms);
  EXPECT_EQ(timers.entries()[0].label, "search");
  EXPECT_EQ(timers.entries()[0].calls, 2U);
  EXPECT_DOUBLE_EQ(timers.entries()[0].seconds(), 0.005);
  EXPECT_DOUBLE_EQ(timers.entries()[1].seconds(), 0.007);
}

TEST(Timers, KnownLabelKeepsItsId) {
  Timers timers;
  int const first = timers.add("search");
  timers.add("forces");
  EXPECT_EQ(timers.add("search"), first);
  EXPECT_EQ(timers.entries().size(), 2U);
}

TEST(ScopedTimer, CountsItsLifetime) {
  Timers timers;
  int const id = timers.add("sleep");
  auto const start = Timers::Clock::now();
  {
    ScopedTimer const timing(timers, id);
    std::this_thread::sleep_for(5ms);
  }
  auto const outer = Timers::Clock::now() - start;
  EXPECT_EQ(timers.entries()[0].calls, 1U);
  EXPECT_GE(timers.entries()[0].total, 5ms);
  EXPECT_LE(timers.entries()[0].total, outer);
}

}  // namespace
}  // namespace moraine
