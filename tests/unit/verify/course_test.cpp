#include "verify/course.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace moraine {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(Course, IsLinearBetweenReadings) {
  Course const course({0.0, 1.0, 3.0}, {none, 2.0, 6.0});
  EXPECT_DOUBLE_EQ(course.at(0.5), 1.0);
  EXPECT_DOUBLE_EQ(course.at(2.0), 4.0);
  EXPECT_TRUE(std::isnan(course.at(3.1)));
  EXPECT_DOUBLE_EQ(course.arrival(1.0), 0.5);
  EXPECT_DOUBLE_EQ(course.arrival(3.0), 1.5);
  EXPECT_TRUE(std::isnan(course.arrival(7.0)));
  Course const twice({0.0, 1.0, 2.0, 3.0}, {0.0, 2.0, 0.0, 2.0});
  EXPECT_DOUBLE_EQ(twice.arrival(1.0), 0.5);
  EXPECT_DOUBLE_EQ(twice.arrival(1.0, 0.9), 2.5);
  EXPECT_DOUBLE_EQ(course.integral(0.0, 3.0), 9.0);
  EXPECT_DOUBLE_EQ(course.integral(0.5, 3.0), 8.0) << "whole intervals only";
  EXPECT_DOUBLE_EQ(course.largest(), 6.0);
  EXPECT_DOUBLE_EQ(course.end(), 3.0);
}

TEST(Course, DifferenceOfTwo) {
  Course const a({0.0, 10.0}, {1.0, 1.0}), b({0.0, 5.0, 10.0}, {1.0, 1.0, 1.0});
  Course const c({0.0, 10.0}, {1.0, 4.0});
  EXPECT_DOUBLE_EQ(rms_difference(a, b, 10.0), 0.0);
  EXPECT_NEAR(rms_difference(a, c, 10.0), std::sqrt(3.0), 1e-6);
}

TEST(Course, IsTakenFromATable) {
  Table const table{{{"time", "s"}, {"p", "Pa"}}, {{0.0, 1.0}, {2.0, 4.0}}};
  EXPECT_DOUBLE_EQ(Course(table, "time", "p").at(0.5), 3.0);
  EXPECT_THROW(Course(table, "time", "q"), std::invalid_argument);
}

}  // namespace
}  // namespace moraine
