#include "blast/estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
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
  for (auto const* name :
       {"kingery_bulmash", "kinney_graham", "brode", "henrych", "three_term_fit"}) {
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

TEST(Answer, OtherAirIsToldAndCarriedOver) {
  Situation high = charge(10.0, 8.0);
  high.air = {70000.0, 0.9};
  Answer const air = answer(Topic::air, high);
  for (auto const* name : {"kingery_bulmash", "kinney_graham", "brode", "henrych"}) {
    auto const estimate = find(air, Measure::peak_overpressure, name);
    EXPECT_TRUE(warns(estimate, "carried over by Sachs' scaling")) << name;
    EXPECT_TRUE(estimate.in_range) << name;
    EXPECT_LT(estimate.value,
              find(answer(Topic::air, charge(10.0, 8.0)), Measure::peak_overpressure, name).value);
  }
}

// Ranges are carried over too: 100 ft/lb^(1/3) of the charge at sea level.
TEST(Answer, RangesAreCarriedOverToOtherAir) {
  Situation high = charge(1.0, 95.0 * foot_per_pound);
  Measure const peak = Measure::peak_overpressure;
  EXPECT_TRUE(find(answer(Topic::air, high), peak, "kingery_bulmash").in_range);
  high.air.pressure = 2.0 * standard_pressure;
  EXPECT_FALSE(find(answer(Topic::air, high), peak, "kingery_bulmash").in_range);
}

// A point source is no charge where the charge weighs more than the air that was swept.
TEST(Answer, PointSourceHasItsLimit) {
  double const limit = std::cbrt(3.0 / (4.0 * std::numbers::pi * standard_density));
  EXPECT_NEAR(limit, 0.58, 0.005);
  for (double const z : {0.57, 0.6}) {
    auto const brode =
        find(answer(Topic::air, charge(1.0, z)), Measure::peak_overpressure, "brode");
    EXPECT_EQ(brode.in_range, z > limit) << z;
  }
}

// A line source holds from where the swept air weighs ten times the charge, at any altitude.
TEST(Answer, LineSourceHasItsLimit) {
  for (double const altitude : {1.0, 0.4}) {
    Air const air{altitude * standard_pressure, altitude * standard_density};
    double const limit = std::sqrt(10.0 / (std::numbers::pi * air.density));  // 1 kg/m
    for (double const factor : {0.99, 1.01}) {
      Situation s = charge(1000.0, factor * limit);
      s.length = 1000.0;
      s.air = air;
      EXPECT_EQ(find(answer(Topic::line, s), Measure::peak_overpressure, "line_source").in_range,
                factor > 1.0);
    }
  }
}

// What an engineer needs of a charge on the ground beside the pressures.
TEST(Answer, SurfaceBurstHasWindAndSpeeds) {
  Answer const surface = answer(Topic::surface, charge(10.0, 8.0));
  double const peak = find(surface, Measure::peak_overpressure, "kingery_bulmash").value;
  Air const air{standard_pressure, standard_density};
  auto const is = [&](Measure measure, double value) {
    EXPECT_DOUBLE_EQ(find(surface, measure, "rankine_hugoniot").value, value);
  };
  is(Measure::dynamic_pressure, dynamic_pressure(peak, air));
  is(Measure::front_speed, front_speed(peak, air));
  is(Measure::particle_speed, particle_speed(peak, air));
  is(Measure::reflected_overpressure, normal_reflection(peak, standard_pressure));
}

// exp(-1) of the peak after one time constant, and no further.
TEST(Answer, PressureUnderWaterFallsWithTime) {
  Situation s = charge(50.0, 20.0);
  EXPECT_EQ(answer(Topic::water, s).unanswered.size(), 1u);
  double const theta = find(answer(Topic::water, s), Measure::time_constant, "swisdak").value;
  double const peak = find(answer(Topic::water, s), Measure::peak_pressure, "swisdak").value;
  s.time = theta;
  auto const last = find(answer(Topic::water, s), Measure::overpressure, "exponential");
  EXPECT_NEAR(last.value, peak / std::exp(1.0), 1e-9 * peak);
  EXPECT_TRUE(last.in_range);
  s.time = 1.01 * theta;
  EXPECT_FALSE(find(answer(Topic::water, s), Measure::overpressure, "exponential").in_range);
  s.distance = 1.2;  // above 138 MPa
  s.time = 0.0;
  EXPECT_FALSE(find(answer(Topic::water, s), Measure::overpressure, "exponential").in_range);
}

// The radius law takes the air above the water as 10 m of water.
TEST(Answer, BubbleLawsAreForWaterAtSeaLevel) {
  Situation s = charge(10.0, unknown);
  s.depth = 30.0;
  auto const radius = [&] {
    return find(answer(Topic::bubble, s), Measure::bubble_radius, "swisdak");
  };
  EXPECT_TRUE(radius().in_range);
  s.water.density = 1025.0;  // sea water
  EXPECT_TRUE(radius().in_range);
  s.water.surface_pressure = 60e3;  // a mountain lake
  EXPECT_TRUE(warns(radius(), "below air of 101.325 kPa"));
  auto const willis = [&] {
    return find(answer(Topic::bubble, s), Measure::bubble_period, "willis");
  };
  EXPECT_FALSE(willis().in_range);
  s.bubble_energy = 2e7;
  EXPECT_TRUE(willis().in_range) << "needs no radius law";
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
