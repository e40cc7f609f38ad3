#include "sweep/draws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace moraine {
namespace {

TEST(Draws, EvenValuesIncludeBothEndsAndReadWell) {
  EXPECT_EQ(even_values({0.1, 0.4, false}, 4), (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(even_values({0.001, 1.0, true}, 4), (std::vector<double>{0.001, 0.01, 0.1, 1.0}));
  EXPECT_EQ(even_values({4.0, 1.0, true}, 3), (std::vector<double>{4.0, 2.0, 1.0}));
}

TEST(Draws, PlacesStandForValues) {
  EXPECT_EQ(value_at(0.0, 3), 0U);
  EXPECT_EQ(value_at(0.5, 3), 1U);
  EXPECT_EQ(value_at(1.0, 3), 2U) << "rounded up from just below";
}

TEST(Draws, LatinHypercubeHasOnePointInEachStratum) {
  std::size_t const samples = 50;
  auto const points = latin_hypercube(3, samples, 3);
  ASSERT_EQ(points.size(), 3U);
  for (auto const& row : points) {
    std::vector<int> strata(samples, 0);
    for (double const value : row) {
      ASSERT_GE(value, 0.0);
      ASSERT_LT(value, 1.0);
      ++strata[static_cast<std::size_t>(value * static_cast<double>(samples))];
    }
    EXPECT_TRUE(std::all_of(strata.begin(), strata.end(), [](int n) { return n == 1; }));
  }
  EXPECT_NE(points[0], points[1]) << "dimensions are drawn apart";
}

// From an implementation of MT19937-64 in Python that gives the 10000th number which the C++
// standard states ([rand.predef], 9981545732273789042).
TEST(Draws, LatinHypercubeIsTheSameOnAnyMachine) {
  auto const points = latin_hypercube(2, 4, 7);
  EXPECT_EQ(points[0], (std::vector<double>{0.4729782941781191, 0.5353178908009467,
                                            0.013773289625985757, 0.9581307451328614}));
  EXPECT_EQ(points[1], (std::vector<double>{0.43893625868502417, 0.8990471951946083,
                                            0.09936136360393347, 0.5771321791568684}));
  EXPECT_NE(latin_hypercube(2, 4, 8), points);
}

}  // namespace
}  // namespace moraine
