#include "blast/displacement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

// 8 lb at 10 ft: Z = 5, W^(1/3) = 2 lb^(1/3).
TEST(Displacement, ValuesOfTheFormulas) {
  double const w = 8.0 * pound, r = 10.0 * foot;
  EXPECT_NEAR(permanent_displacement(w, r, 126.0) / inch, 2.0 * 126.0 / 625.0, 1e-12);
  EXPECT_NEAR(transient_horizontal_displacement(w, r) / inch, 2.0 * (47.3 / 125.0 + 0.216 / 5.0),
              1e-12);
  EXPECT_NEAR(transient_vertical_displacement(w, r) / inch, 2.0 * (12.6 / 125.0 + 0.032 / 5.0),
              1e-12);
}

// Corrected: the source swaps clay and chalk in the vertical list, by which chalk would rise
// six times as far as it is pushed aside.
TEST(Displacement, GroundsMoveAsideMoreThanUp) {
  ASSERT_EQ(displaced_grounds().size(), 3u);
  for (DisplacedGround const& ground : displaced_grounds())
    EXPECT_LT(ground.vertical, ground.horizontal) << ground.name;
  EXPECT_EQ(find_displaced_ground("clay")->vertical, 145.0);
  EXPECT_EQ(find_displaced_ground("peat"), nullptr);
}

TEST(Displacement, FallsWithDistance) {
  for (double r = 1.0; r < 10.0; r *= 1.1) {
    EXPECT_LT(permanent_displacement(10.0, 1.1 * r, 200.0), permanent_displacement(10.0, r, 200.0));
    EXPECT_LT(transient_horizontal_displacement(10.0, 1.1 * r),
              transient_horizontal_displacement(10.0, r));
    EXPECT_LT(transient_vertical_displacement(10.0, 1.1 * r),
              transient_vertical_displacement(10.0, r));
  }
}

}  // namespace
}  // namespace moraine::blast
