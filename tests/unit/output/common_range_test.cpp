// One colour scale for the frames of a run.
#include <gtest/gtest.h>

#include "output/plot/color_bar.hpp"

namespace moraine::plot {
namespace {

TEST(CommonRange, IsThatOfTheMiddleFrame) {
  // The first frame of a blast is a thousand times as bright as the others.
  ColorRange const range =
      common_range({{0.0, 8e9}, {-2e6, 4e7}, {-1e6, 2e7}, {-3e6, 1e7}, {0.0, 3e7}});
  EXPECT_EQ(range.low, -1e6);
  EXPECT_EQ(range.high, 3e7);
}

TEST(CommonRange, TakesTheWiderOfTwo) {
  ColorRange const range = common_range({{0.0, 1.0}, {-2.0, 0.5}});
  EXPECT_EQ(range.low, -2.0);
  EXPECT_EQ(range.high, 1.0);
}

}  // namespace
}  // namespace moraine::plot
