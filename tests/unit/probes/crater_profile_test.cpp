// Profiles whose crater is known.
#include "probes/crater_profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace moraine {
namespace {

template <class Height>
CraterProfile sampled(double step, double end, Height&& height) {
  CraterProfile profile{step, {}};
  for (int k = 0; k * step <= end + 1e-12; ++k) profile.height.push_back(height(k * step));
  return profile;
}

// A cone of depth 2 and radius 3 with a rim of height 1 at 4.5: straight pieces between samples are
// exact for both the crossing and the plane content, 2 * 3 / 2.
TEST(CraterProfile, OfStraightPiecesIsExact) {
  auto const cone = [](double r) {
    return r < 4.5 ? -2.0 + r * 2.0 / 3.0 : std::max(0.0, 1.0 - (r - 4.5));
  };
  auto const reading = read_profile(sampled(0.25, 10.0, cone), 0.1, false);
  EXPECT_NEAR(reading.apparent_radius, 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(reading.depth, 2.0);
  EXPECT_NEAR(reading.rim_radius, 4.5, 1e-12);
  EXPECT_NEAR(reading.rim_height, 1.0, 1e-12);
  EXPECT_NEAR(reading.content, 3.0, 1e-12);
}

// Of the paraboloid, integral of D (1 - r^2 / a^2) r dr = D a^2 / 4; the trapezoidal rule is of
// second order: (step / a)^2 of it.
TEST(CraterProfile, OfAParaboloidHasItsContent) {
  for (double const step : {0.1, 0.05}) {
    auto const reading = read_profile(
        sampled(step, 4.0, [](double r) { return r < 2.0 ? r * r / 4.0 - 1.0 : 0.0; }), 1e-3, true);
    EXPECT_NEAR(reading.content, 1.0, step * step / 4.0);
    EXPECT_NEAR(reading.apparent_radius, 2.0, step) << "no rim: where the depth is lost";
    EXPECT_EQ(reading.rim_height, 0.0);
    EXPECT_EQ(reading.rim_radius, reading.apparent_radius);
  }
}

TEST(CraterProfile, OfFlatGroundIsNothing) {
  auto const reading =
      read_profile(sampled(0.1, 4.0, [](double r) { return 0.01 * std::sin(r); }), 0.1, true);
  EXPECT_EQ(reading.depth, 0.0);
  EXPECT_EQ(reading.apparent_radius, 0.0);
  EXPECT_EQ(reading.content, 0.0);
}

TEST(CraterProfile, WithoutAnEndHasNoRadius) {
  auto const reading = read_profile(sampled(0.5, 4.0, [](double) { return -1.0; }), 0.1, false);
  EXPECT_TRUE(std::isnan(reading.apparent_radius));
  EXPECT_DOUBLE_EQ(reading.depth, 1.0);
  EXPECT_NEAR(reading.content, 4.0, 1e-12);
}

// The hill in the middle of the crater does not end it.
TEST(CraterProfile, ACentralPeakIsPartOfTheCrater) {
  auto const ring = [](double r) { return r < 1.0 ? 0.5 - 1.5 * r : -1.0 + 0.5 * (r - 1.0); };
  auto const reading = read_profile(sampled(0.125, 8.0, ring), 0.01, false);
  EXPECT_NEAR(reading.apparent_radius, 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(reading.depth, 1.0);
}

}  // namespace
}  // namespace moraine
