#include "blast/sachs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "blast/estimate.hpp"

namespace moraine::blast {
namespace {

double value(Topic topic, Measure measure, std::string_view relation, Situation const& s) {
  Answer const all = answer(topic, s);
  auto const found = std::ranges::find_if(all.estimates, [&](Estimate const& estimate) {
    return estimate.relation->measure == measure && estimate.relation->name == relation;
  });
  EXPECT_NE(found, all.estimates.end()) << relation;
  return found->value;
}

Situation at(double distance, Air const& air) {
  Situation s;
  s.charge_mass = 10.0;
  s.distance = distance;
  s.air = air;
  return s;
}

constexpr Air standard{standard_pressure, standard_density};

TEST(Sachs, ChangesNothingAtSeaLevel) {
  Situation const s = at(5.0, standard);
  EXPECT_EQ(at_sea_level(s).charge_mass, s.charge_mass);
  for (Kind const kind : {Kind::pressure, Kind::impulse, Kind::time, Kind::speed, Kind::length})
    EXPECT_EQ(sachs_factor(kind, standard), 1.0);
}

// A point source of 4.61 MJ/kg in an ideal gas has one strong-blast limit: pressures near it do not
// depend on the pressure of the air, only on its density. The first term of Brode's formula is that
// limit; his 1 bar follows the ambient pressure.
TEST(Sachs, StrongBlastDoesNotFeelTheAmbientPressure) {
  for (double const factor : {0.3, 0.5, 2.0}) {
    Air const air{factor * standard_pressure, standard_density};
    double const r = 1.3;
    double const there = value(Topic::air, Measure::peak_overpressure, "brode", at(r, standard));
    double const here = value(Topic::air, Measure::peak_overpressure, "brode", at(r, air));
    EXPECT_NEAR(here - there, (factor - 1.0) * 1e5, 1e-9 * there) << factor;
  }
}

// Arrival times that were carried over must belong to the peaks that were: dR/dt is the speed of a
// front of that overpressure in that very air, by the jump conditions.
TEST(Sachs, FrontsMoveByTheJumpConditionsOfTheirAir) {
  for (Air const& air : {Air{70e3, 0.9}, Air{30e3, 0.46}, Air{101325.0, 1.45}, Air{3e5, 3.6}})
    for (Topic const topic : {Topic::air, Topic::surface})
      for (double const r : {2.0, 5.0, 12.0, 30.0}) {
        auto const arrival = [&](double distance) {
          return value(topic, Measure::arrival_time, "kingery_bulmash", at(distance, air));
        };
        double const dr = 1e-4 * r;
        double const speed = 2.0 * dr / (arrival(r + dr) - arrival(r - dr));
        double const peak = value(topic, Measure::peak_overpressure, "kingery_bulmash", at(r, air));
        double const front = front_speed(peak, air);
        EXPECT_NEAR(speed, front, 0.05 * front) << air.pressure << " Pa, " << r << " m";
        EXPECT_NEAR(value(topic, Measure::front_speed, "rankine_hugoniot", at(r, air)), front,
                    1e-9 * front);
      }
}

// Impulse, peak and duration are carried over by factors of their own: the shape of the pulse, I/(p
// t), must stay that at sea level.
TEST(Sachs, PulsesKeepTheirShape) {
  Air const air{50e3, 0.75};
  for (double const r : {4.0, 8.0, 20.0}) {
    auto const of = [&](Measure measure) {
      return value(Topic::air, measure, "kingery_bulmash", at(r, air));
    };
    auto const sea = [&](Measure measure) {
      Situation const same = at_sea_level(at(r, air));
      return value(Topic::air, measure, "kingery_bulmash", same);
    };
    auto const share = [](auto const& law) {
      return law(Measure::impulse) /
             (law(Measure::peak_overpressure) * law(Measure::positive_duration));
    };
    EXPECT_NEAR(share(of), share(sea), 1e-12);
  }
}

}  // namespace
}  // namespace moraine::blast
