#include "report/quantised.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace moraine::report {
namespace {

Interval interval_of(std::vector<double> const& values) {
  Interval interval;
  for (double const value : values) interval.include(value);
  return interval;
}

// Half a step is all that is lost: 1 / 131068 of the range.
TEST(Quantised, LosesHalfAStepAtMost) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(-3.0 + 8.0 * std::sqrt(i / 999.0));
  Interval const range = interval_of(values);
  auto const q = quantised(values, range);
  for (std::size_t i = 0; i < values.size(); ++i) {
    double const back = range.min() + q[i] / steps_of_16_bits * (range.max() - range.min());
    EXPECT_NEAR(back, values[i], 0.5 * 8.0 / steps_of_16_bits * 1.0001);
  }
  EXPECT_EQ(q.front(), 0);
  EXPECT_EQ(q.back(), 65534);
}

TEST(Quantised, HoldsWhatIsNone) {
  std::vector<double> const values{1.0, std::numeric_limits<double>::quiet_NaN(), 2.0,
                                   std::numeric_limits<double>::infinity()};
  auto const q = quantised(values, interval_of(values));
  EXPECT_EQ(q, (std::vector<std::uint16_t>{0, 65535, 65534, 65535}));
}

TEST(Quantised, IsZeroInARangeWithoutLength) {
  std::vector<double> const values{4.0, 4.0};
  EXPECT_EQ(quantised(values, interval_of(values)), (std::vector<std::uint16_t>{0, 0}));
  EXPECT_EQ(interval_of({}).max(), 0.0);
}

TEST(Quantised, SpansTheLargestNumbers) {
  std::vector<double> const values{-1.7e308, 0.0, 1.7e308};
  EXPECT_EQ(quantised(values, interval_of(values)), (std::vector<std::uint16_t>{0, 32767, 65534}));
}

}  // namespace
}  // namespace moraine::report
