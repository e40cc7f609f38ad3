#include "blast/crater.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "blast/scales.hpp"
#include "support/reference_data.hpp"

namespace moraine::blast {
namespace {

TEST(Crater, DiametersOfTheFormulas) {
  EXPECT_NEAR(crater_diameter(1000.0, kinney_graham_crater), 8.0, 1e-12);
  EXPECT_NEAR(crater_diameter(10.0, ambrosini_crater), 1.0987617, 1e-6);
  EXPECT_NEAR(crater_diameter(10.0, hemispherical_crater), 1.4003825, 1e-6);
  // 1 lb in loam of 2000 psi: 2.6 * 2000^0.05 ft = 3.802 ft, not the 116 ft of the printed power.
  EXPECT_NEAR(lampson_crater_diameter(pound, 2000.0, 1.0) / foot, 3.802, 0.001);
}

TEST(Crater, AgreesWithTheTable) {
  MORAINE_NEED_SHARED_DATA("blast/crater_diameter_laws.csv");
  auto const rows = csv_numbers(shared_data("blast/crater_diameter_laws.csv"));
  ASSERT_EQ(rows.size(), 9u);
  for (auto const& row : rows) {
    EXPECT_NEAR(crater_diameter(row[0], kinney_graham_crater), row[1], 1e-7 * row[1]);
    EXPECT_NEAR(crater_diameter(row[0], ambrosini_crater), row[2], 1e-7 * row[2]);
    EXPECT_NEAR(crater_diameter(row[0], hemispherical_crater), row[3], 1e-7 * row[3]);
  }
}

TEST(Crater, RuptureRadiusAndCamouflet) {
  EXPECT_NEAR(rupture_radius(8.0 * pound, 6.2) / foot, 12.4, 1e-12);
  EXPECT_NEAR(camouflet_volume(3.0 * pound), 30.0 * foot * foot * foot, 1e-12);
  ASSERT_EQ(broken_grounds().size(), 9u);
  double last = 0.0;  // softer grounds break farther
  for (BrokenGround const& ground : broken_grounds()) {
    EXPECT_GE(ground.high, ground.low) << ground.name;
    EXPECT_GE(ground.low, last) << ground.name;
    last = ground.low;
  }
  EXPECT_EQ(find_broken_ground("fill")->high, 9.7);
}

// A cavity in clay: a sphere of 10 ft^3/lb has a radius of 1.34 ft/lb^(1/3), a fifth of the rupture
// radius.
TEST(Crater, CamoufletLiesInsideTheRuptureRadius) {
  double const radius = std::cbrt(3.0 * camouflet_volume(5.0) / (4.0 * std::numbers::pi));
  EXPECT_LT(radius, 0.25 * rupture_radius(5.0, find_broken_ground("clay")->low));
}

TEST(Crater, TypesByDepth) {
  double const clay = find_broken_ground("clay")->low, w = 10.0;
  double const charge = charge_radius(w), broken = rupture_radius(w, clay);
  EXPECT_NEAR(4.0 / 3.0 * std::numbers::pi * std::pow(charge, 3) * 1630.0, w, 1e-12);
  EXPECT_EQ(crater_type(w, 0.0, clay), CraterType::scour);
  EXPECT_EQ(crater_type(w, 1.01 * charge, clay), CraterType::throw_out);
  EXPECT_EQ(crater_type(w, 0.99 * broken, clay), CraterType::throw_out);
  EXPECT_EQ(crater_type(w, 1.01 * broken, clay), CraterType::camouflet);
}

}  // namespace
}  // namespace moraine::blast
