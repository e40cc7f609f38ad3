// Arrival and positive phase of made-up readings.
#include "probes/reading_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace moraine {
namespace {

ReadingSummary summary_of(std::vector<std::pair<double, double>> const& readings, double rise) {
  ReadingSummary summary;
  summary.set_rise(rise);
  for (auto const& [time, value] : readings) summary.add(time, value);
  return summary;
}

// Rises by 8 in [1, 2], is back at the start value at 5 on its way from 2 above at 4 to 2 below.
TEST(ReadingSummary, ThePositivePhaseEndsAtTheStartValue) {
  auto const summary =
      summary_of({{0, 100}, {1, 100}, {2, 108}, {3, 104}, {4, 102}, {6, 98}, {7, 103}, {8, 97}}, 2);
  EXPECT_DOUBLE_EQ(summary.arrival(), 1.25);
  EXPECT_DOUBLE_EQ(summary.duration(), 5.0 - 1.25);
}

TEST(ReadingSummary, AReadingThatMeetsTheStartValueEndsThePhase) {
  auto const summary = summary_of({{0, 1}, {1, 5}, {2, 1}, {3, 0}}, 4);
  EXPECT_DOUBLE_EQ(summary.duration(), 1.0);
}

TEST(ReadingSummary, ThePhaseOfTheLargestReadingCounts) {
  auto const summary = summary_of({{0, 0}, {1, 4}, {2, -4}, {3, 8}, {4, 0}}, 2);
  EXPECT_DOUBLE_EQ(summary.arrival(), 0.5);
  EXPECT_DOUBLE_EQ(summary.duration(), 3.5);
}

TEST(ReadingSummary, AnUnfinishedPhaseHasNoDuration) {
  EXPECT_TRUE(std::isnan(summary_of({{0, 0}, {1, 4}, {2, 1}}, 2).duration()));
  EXPECT_TRUE(std::isnan(summary_of({{0, 0}, {1, 1}, {2, -1}}, 2).duration())) << "no arrival";
  auto const larger_again = summary_of({{0, 0}, {1, 4}, {2, -4}, {3, 8}}, 2);
  EXPECT_TRUE(std::isnan(larger_again.duration()));
}

}  // namespace
}  // namespace moraine
