#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/bisect.hpp"
#include "base/power.hpp"

namespace moraine {
namespace {

// Squaring rounds once per multiplication; eleven multiplications (64 = 2^6 and the loop's own)
// stay below 64 units of rounding, as an early error is raised to the remaining power.
TEST(Power, AgreesWithTheLibrary) {
  for (double const exponent : {0.0, 1.0, 2.0, 6.0, 7.0, 13.0, 64.0, 65.0, 1.4, 0.5, -2.0, -1.5})
    for (double const x : {0.3, 0.999, 1.0, 1.01, 2.5}) {
      double const expected = std::pow(x, exponent);
      EXPECT_NEAR(power(x, exponent), expected, 64 * 1.2e-16 * expected) << x << "^" << exponent;
    }
  EXPECT_EQ(power(0.0, 7.0), 0.0);
  EXPECT_EQ(power(3.0, 7.0), 2187.0);
  EXPECT_TRUE(std::isnan(power(2.0, std::nan(""))));
}

TEST(Bisect, FindsZerosToTheLastBit) {
  auto const root = bisect([](double x) { return std::cos(x); }, 0.0, 3.0);
  EXPECT_NEAR(root, std::numbers::pi / 2, 3e-16);
  auto const rising = bisect([](double x) { return x * x * x - 8.0; }, -100.0, 1e6);
  EXPECT_NEAR(rising, 2.0, 5e-16);
}

TEST(Bisect, TakesEitherOrderOfTheEnds) {
  EXPECT_NEAR(bisect([](double x) { return x - 0.25; }, 1.0, 0.0), 0.25, 1e-16);
}

}  // namespace
}  // namespace moraine
