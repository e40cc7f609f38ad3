// Power laws give their exponent; what is no number takes no part.
#include "probes/decay_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace moraine {
namespace {

TEST(DecayFit, APowerLawGivesItsExponent) {
  std::vector<double> const r{0.1, 0.15, 0.3, 0.7, 2.0};
  for (double const n : {-1.13, -3.0, 0.5}) {
    std::vector<double> p;
    for (double const distance : r) p.push_back(52.4e6 * std::pow(distance, n));
    DecayFit const fit = fit_decay(r, p);
    EXPECT_NEAR(fit.exponent, n, 1e-12);
    EXPECT_NEAR(fit.scatter, 0.0, 1e-12);
    EXPECT_EQ(fit.points, 5U);
  }
}

// y = 0, 1, 0 at x = 0, 1, 2: the line is flat at 1/3, the squares are 1/9, 4/9, 1/9.
TEST(DecayFit, TheScatterIsTheRootMeanSquareOfTheDifferences) {
  std::vector<double> const r{1.0, std::exp(1.0), std::exp(2.0)};
  std::vector<double> const p{1.0, std::exp(1.0), 1.0};
  DecayFit const fit = fit_decay(r, p);
  EXPECT_NEAR(fit.exponent, 0.0, 1e-14);
  EXPECT_NEAR(fit.scatter, std::sqrt(2.0 / 9.0), 1e-14);
}

TEST(DecayFit, WhatIsNotPositiveIsLeftOut) {
  double const none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> const r{0.0, 1.0, 2.0, 4.0, 8.0};
  std::vector<double> const p{9.0, 8.0, none, 2.0, -1.0};
  DecayFit const fit = fit_decay(r, p);
  EXPECT_NEAR(fit.exponent, -1.0, 1e-12);
  EXPECT_EQ(fit.points, 2U);
}

TEST(DecayFit, OneDistanceGivesNone) {
  EXPECT_TRUE(std::isnan(fit_decay({}, {}).exponent));
  std::vector<double> const r{2.0, 2.0};
  std::vector<double> const p{1.0, 3.0};
  EXPECT_TRUE(std::isnan(fit_decay(r, p).exponent));
  EXPECT_EQ(fit_decay(r, p).points, 2U);
}

}  // namespace
}  // namespace moraine
