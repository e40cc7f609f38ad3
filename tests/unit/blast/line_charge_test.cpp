#include "blast/line_charge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

// E = 8 p_a m^3, L = 2 m: 8/4, sqrt(8/2), 8^(1/3).
TEST(LineCharge, SachsLengths) {
  EXPECT_NEAR(sachs_length(Source::plane, 8e5, 2.0, 1e5), 2.0, 1e-14);
  EXPECT_NEAR(sachs_length(Source::line, 8e5, 2.0, 1e5), 2.0, 1e-14);
  EXPECT_NEAR(sachs_length(Source::point, 8e5, 2.0, 1e5), 2.0, 1e-14);
  EXPECT_NEAR(sachs_length(Source::line, 8e5, 8.0, 1e5), 1.0, 1e-14);
}

// Sedov's strong cylindrical blast: p = 2/(gamma+1) (1/4)/alpha E/(L R^2), alpha = 0.98404, the
// energy 0.311357 that reaches 0.75 at t = 1 in the tables of Sedov's solution.
TEST(LineCharge, NearEndIsSedov) {
  double const alpha = 0.311357 / std::pow(0.75, 4);
  for (double const r : {1e-4, 1e-3, 2e-3}) {
    double const sedov = 2.0 / 2.4 * 0.25 / alpha / (r * r);
    EXPECT_NEAR(line_source_overpressure(r), sedov, 2e-4 * sedov) << r;
  }
}

// Rows of the table of Blast::IPS, cylinder, gamma = 1.4, that are not interpolated through:
// ln(R/R_0), ln(p/p_a).
TEST(LineCharge, InterpolatesTheTable) {
  double const rows[][2] = {{-4.62390128, 7.69576248}, {-3.4611564, 5.3750483},
                            {-2.3418038, 3.17760557},  {-1.34032654, 1.37924013},
                            {-0.46681745, 0.09613807}, {0.20954738, -0.72028937},
                            {1.3080627, -1.83827819},  {2.40599868, -2.81405657},
                            {3.78047383, -3.93927677}, {5.55096048, -5.31744619}};
  for (auto const& [x, y] : rows)
    EXPECT_NEAR(std::log(line_source_overpressure(std::exp(x))), y, 2e-4) << x;
}

TEST(LineCharge, FallsFromInverseSquareToThreeQuarters) {
  double last_slope = -2.1;
  for (double x = -9.0; x < 9.0; x += 0.25) {
    double const slope = (std::log(line_source_overpressure(std::exp(x + 0.01))) -
                          std::log(line_source_overpressure(std::exp(x)))) /
                         0.01;
    EXPECT_GT(slope, last_slope - 2e-3) << x;
    EXPECT_LT(slope, -0.75);
    last_slope = slope;
  }
}

// Twice the charge on twice the length is the same charge, seen from beside.
TEST(LineCharge, DependsOnTheMassPerLength) {
  EXPECT_DOUBLE_EQ(line_scaled_distance(3.0, 2.0, 5.0), line_scaled_distance(6.0, 4.0, 5.0));
  EXPECT_DOUBLE_EQ(line_scaled_distance(4.0, 1.0, 6.0), 3.0);
}

}  // namespace
}  // namespace moraine::blast
