#include "blast/buried.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

/// 8 lb in loam at 10 ft: Z = 5.
constexpr BuriedCharge charge{8.0 * pound, 10.0 * foot, 2000.0, 1.0, 1.0};

TEST(Buried, ValuesOfTheFormulas) {
  EXPECT_NEAR(buried_pressure(charge) / psi, 2000.0 / 125.0, 1e-10);
  EXPECT_NEAR(buried_impulse(charge) / psi, 0.076 * std::sqrt(2000.0) * 2.0 * std::pow(5.0, -2.5),
              1e-12);
  EXPECT_NEAR(buried_positive_duration(charge), 0.174 * std::sqrt(10.0 * 2.0 / 2000.0), 1e-12);
  EXPECT_NEAR(buried_negative_duration(charge) / buried_positive_duration(charge), 0.368 / 0.174,
              1e-12);
}

// The corrected powers: the duration stays 0.174/0.152 times that of a triangle, everywhere.
TEST(Buried, DurationGrowsWithTwiceImpulseOverPressure) {
  for (double const w : {0.1, 10.0, 1000.0})
    for (double const z : {2.0, 5.0, 15.0})
      for (Soil const& soil : soils()) {
        BuriedCharge const other{w, z * foot_per_pound * std::cbrt(w), soil.k, 1.0, 1.0};
        double const triangle = 2.0 * buried_impulse(other) / buried_pressure(other);
        EXPECT_NEAR(buried_positive_duration(other) / triangle, 0.174 / 0.152, 1e-9) << soil.name;
      }
}

TEST(Buried, ExplosiveAndCouplingActOnPressureAndImpulse) {
  BuriedCharge other = charge;
  other.explosive_factor = 1.3;
  other.coupling = 0.5;
  EXPECT_NEAR(buried_pressure(other), 0.65 * buried_pressure(charge), 1e-9);
  EXPECT_NEAR(buried_impulse(other), 0.65 * buried_impulse(charge), 1e-9);
  EXPECT_EQ(buried_positive_duration(other), buried_positive_duration(charge));
}

TEST(Buried, ScalesGeometrically) {
  BuriedCharge large = charge;
  large.mass *= 27.0;
  large.distance *= 3.0;
  EXPECT_NEAR(buried_pressure(large), buried_pressure(charge), 1e-9);
  EXPECT_NEAR(buried_impulse(large), 3.0 * buried_impulse(charge), 1e-9);
  EXPECT_NEAR(buried_positive_duration(large), 3.0 * buried_positive_duration(charge), 1e-12);
}

TEST(Buried, ListOfSoils) {
  ASSERT_EQ(soils().size(), 9u);
  EXPECT_EQ(find_soil("limestone")->k, 590000.0);
  EXPECT_EQ(find_soil("marble"), nullptr);
  for (Soil const& soil : soils()) EXPECT_EQ(soil.doubtful, soil.name == "sandy_clay");
}

}  // namespace
}  // namespace moraine::blast
