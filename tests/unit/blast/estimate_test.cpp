#include "blast/estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "blast/kingery_bulmash.hpp"

namespace moraine::blast {
namespace {

Situation charge(double mass, double distance) {
  Situation s;
  s.charge_mass = mass;
  s.distance = distance;
  return s;
}

Estimate find(Answer const& answer, Measure measure, std::string_view relation) {
  auto const found = std::ranges::find_if(answer.estimates, [&](Estimate const& estimate) {
    return estimate.relation->measure == measure && estimate.relation->name == relation;
  });
  EXPECT_NE(found, answer.estimates.end()) << relation;
  return *found;
}

bool warns(Estimate const& estimate, std::string_view words) {
  return std::ranges::any_of(estimate.warnings, [&](std::string const& warning) {
    return warning.find(words) != std::string::npos;
  });
}

TEST(Answer, HoldsAllThatApplyAndTheirSpread) {
  Answer const air = answer(Topic::air, charge(10.0, 8.0));
  Measure const peak = Measure::peak_overpressure;
  EXPECT_EQ(std::ranges::count(air.estimates, peak,
                               [](Estimate const& e) { return e.relation->measure; }),
            9);
  auto const kingery = find(air, peak, "kingery_bulmash");
  EXPECT_DOUBLE_EQ(kingery.value, kingery_overpressure(Burst::free_air, 8.0 / std::cbrt(10.0)));
  EXPECT_TRUE(kingery.in_range);
  EXPECT_TRUE(kingery.warnings.empty());
  auto const spread = std::ranges::find(air.spreads, peak, &Spread::measure);
  ASSERT_NE(spread, air.spreads.end());
  EXPECT_EQ(spread->count, 5);  // without the four doubtful ones
  double low = INFINITY, high = 0.0;
  for (auto const* name : {"kingery_bulmash", "kinney_graham", "brode", "henrych", "thesis_fit"}) {
    low = std::min(low, find(air, peak, name).value);
    high = std::max(high, find(air, peak, name).value);
  }
  EXPECT_EQ(spread->low, low);
  EXPECT_EQ(spread->high, high);
}

TEST(Answer, DoubtfulOnesCarryTheirDoubt) {
  Answer const air = answer(Topic::air, charge(10.0, 8.0));
  auto const block = find(air, Measure::peak_overpressure, "tnt_block_1_lb");
  EXPECT_EQ(block.standing, Standing::doubtful);
  EXPECT_TRUE(warns(block, "differ fivefold"));
  EXPECT_TRUE(warns(block, "states no range"));
}

TEST(Answer, OutsideARangeThereIsAWarning) {
  Answer const near = answer(Topic::air, charge(1.0, 0.05));
  for (Estimate const& estimate : near.estimates) {
    bool const in_range = estimate.in_range && estimate.standing != Standing::doubtful;
    EXPECT_EQ(in_range, estimate.warnings.empty()) << estimate.relation->name;
  }
  auto const kingery = find(near, Measure::peak_overpressure, "kingery_bulmash");
  EXPECT_FALSE(kingery.in_range);
  EXPECT_TRUE(
      warns(kingery, "R/W^(1/3) is 0.126 ft/lb^(1/3), it holds for R/W^(1/3) of 0.134 to 100"))
      << kingery.warnings.front();
}

// The ends of a range belong to it.
TEST(Answer, EndsOfARangeBelongToIt) {
  double const end = 100.0 * foot_per_pound;
  for (double const factor : {1.0, 1.0 + 1e-9}) {
    Answer const air = answer(Topic::air, charge(1.0, factor * end));
    EXPECT_EQ(find(air, Measure::peak_overpressure, "kingery_bulmash").in_range, factor == 1.0);
  }
}

// 0.906 to 0.930 m/kg^(1/3): neither piece of Brode's formula is in its range.
TEST(Answer, BrodeHasAGap) {
  for (double const z : {0.90, 0.91, 0.925, 0.935}) {
    Answer const air = answer(Topic::air, charge(1.0, z));
    bool const gap = z > 0.906 && z < 0.930;
    auto const brode = find(air, Measure::peak_overpressure, "brode");
    EXPECT_EQ(brode.in_range, !gap) << z;
    EXPECT_EQ(warns(brode, "between its two pieces"), gap) << z;
  }
}

TEST(Answer, OtherAirIsOutsideWhatWasMeasured) {
  Situation high = charge(10.0, 8.0);
  high.air = {70000.0, 0.9};
  Answer const air = answer(Topic::air, high);
  EXPECT_TRUE(warns(find(air, Measure::peak_overpressure, "kingery_bulmash"), "at sea level"));
  EXPECT_TRUE(find(air, Measure::peak_overpressure, "kinney_graham").in_range);
  EXPECT_EQ(std::ranges::find(air.spreads, Measure::peak_overpressure, &Spread::measure),
            air.spreads.end())
      << "one relation has no spread";
}

TEST(Answer, SaysWhatItNeeds) {
  Answer const crater = answer(Topic::crater, charge(10.0, unknown));
  ASSERT_EQ(crater.unanswered.size(), 3u);
  EXPECT_EQ(crater.unanswered[0].needs, "a soil and a depth factor");
  EXPECT_EQ(crater.estimates.size(), 3u);
}

TEST(Answer, ReflectionSaysWhereItHasNoSolution) {
  Situation s;
  s.overpressure = 2e5;
  s.angle = 0.9;  // 51.6 degrees
  Answer const steep = answer(Topic::reflection, s);
  auto const regular = find(steep, Measure::reflected_overpressure, "two_shock");
  EXPECT_TRUE(std::isnan(regular.value));
  EXPECT_FALSE(regular.in_range);
  EXPECT_TRUE(warns(regular, "no regular reflection above 40.22 degrees"));
  EXPECT_GT(find(steep, Measure::stem_overpressure, "three_shock").value, s.overpressure);
  s.angle = 0.5;
  Answer const flat = answer(Topic::reflection, s);
  EXPECT_TRUE(find(flat, Measure::reflected_overpressure, "two_shock").in_range);
  EXPECT_TRUE(warns(find(flat, Measure::stem_overpressure, "three_shock"), "no Mach stem"));
}

TEST(Answer, UncertainSoilIsDoubtful) {
  Situation s = charge(10.0, 5.0);
  s.coupling = 1.0;
  s.soil = find_soil("sandy_clay");
  Answer const ground = answer(Topic::buried, s);
  auto const pressure = find(ground, Measure::peak_pressure, "lampson");
  EXPECT_EQ(pressure.standing, Standing::doubtful);
  EXPECT_TRUE(warns(pressure, "15 000 is likely"));
}

TEST(Answer, GroundFactorHasItsRange) {
  Situation s = charge(10.0, 8.0);
  Measure const peak = Measure::peak_overpressure;
  Answer const surface = answer(Topic::surface, s);
  auto const usual = find(surface, peak, "kinney_graham_enlarged");
  EXPECT_TRUE(usual.in_range);
  EXPECT_LT(usual.low, usual.value);
  EXPECT_GT(usual.high, usual.value);
  s.ground_factor = 1.5;
  EXPECT_FALSE(find(answer(Topic::surface, s), peak, "kinney_graham_enlarged").in_range);
}

}  // namespace
}  // namespace moraine::blast
