#include "watch/spark_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace moraine::watch {
namespace {

using Values = std::vector<double>;

TEST(SparkLine, RisesWithTheValues) {
  EXPECT_EQ(spark_line(Values{0, 1, 2, 3, 4, 5, 6, 7}, 8), "▁▂▃▄▅▆▇█");
}

TEST(SparkLine, ShowsPeaksOfManyValues) {
  Values values(1000, 0.0);
  values[503] = 7.0;
  EXPECT_EQ(spark_line(values, 4), "▁▁█▁");
}

TEST(SparkLine, LeavesHolesWhereThereAreNoNumbers) {
  double const none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(spark_line(Values{0, none, 1}, 10), "▁ █");
  EXPECT_EQ(spark_line(Values{none, none}, 10), "  ");
  EXPECT_EQ(spark_line(Values{}, 10), "");
}

TEST(SparkLine, IsLowWhereNothingHappens) { EXPECT_EQ(spark_line(Values{5, 5}, 9), "▁▁"); }

}  // namespace
}  // namespace moraine::watch
