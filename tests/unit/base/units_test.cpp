#include "base/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

namespace moraine {
namespace {

struct Good {
  char const* text;
  Quantity quantity;
  double value;
};

// Compared bit for bit (EXPECT_DOUBLE_EQ: 4 units in the last place for factors above one).
TEST(Units, ConvertsToSi) {
  for (auto const& [text, quantity, value] : {
           Good{"4 cm", Quantity::length, 0.04},
           Good{"0 m", Quantity::length, 0.0},
           Good{"  4cm ", Quantity::length, 0.04},
           Good{"+1.5e1 mm", Quantity::length, 0.015},
           Good{"1.63 g/cm^3", Quantity::density, 1630.0},
           Good{"1630 kg m-3", Quantity::density, 1630.0},
           Good{"1630 kg/m3", Quantity::density, 1630.0},
           Good{"500 us", Quantity::time, 500e-6},
           Good{"500 \u00b5s", Quantity::time, 500e-6},
           Good{"500 \u03bcs", Quantity::time, 500e-6},
           Good{"-9.81 m/s^2", Quantity::acceleration, -9.81},
           Good{"2 g0", Quantity::acceleration, 2 * 9.80665},
           Good{"-1 g0", Quantity::acceleration, -9.80665},
           Good{"6.93 km/s", Quantity::velocity, 6930.0},
           Good{"371.2 GPa", Quantity::pressure, 3.712e11},
           Good{"1 bar", Quantity::pressure, 1e5},
           Good{"1 atm", Quantity::pressure, 101325.0},
           Good{"4.29 MJ/kg", Quantity::specific_energy, 4.29e6},
           Good{"2 t", Quantity::mass, 2000.0},
           Good{"1.2", Quantity::number, 1.2},
           Good{"5 %", Quantity::number, 0.05},
           Good{"180 deg", Quantity::angle, std::numbers::pi},
       }) {
    Conversion const result = to_si(text, quantity);
    ASSERT_TRUE(result.value.has_value()) << text << ' ' << result.rule;
    EXPECT_DOUBLE_EQ(*result.value, value) << text;
    EXPECT_EQ(result.rule, "") << text;
  }
}

// "9 mm" times 0.001 would be 0.0090000000000000011.
TEST(Units, RoundsDecimalFractionsOnce) {
  for (int i = 1; i <= 999; ++i) {
    EXPECT_EQ(*to_si(std::to_string(i) + " mm", Quantity::length).value, i / 1000.0);
    EXPECT_EQ(*to_si(std::to_string(i) + " us", Quantity::time).value, i / 1e6);
  }
}

struct Bad {
  char const* text;
  Quantity quantity;
  char const* rule;
  char const* hint;
};

TEST(Units, SaysWhatIsWrong) {
  for (auto const& [text, quantity, rule, hint] : {
           Bad{"3 kg", Quantity::density, "is a mass; a density is expected (kg/m^3)", ""},
           Bad{"0.35 g", Quantity::acceleration, "is a mass; an acceleration is expected (m/s^2)",
               "g is gram; did you mean \"0.35 g0\" (standard gravity)?"},
           Bad{"4", Quantity::length, "is a plain number; a length is expected (m)",
               "write 4 without quotes for SI, or \"4 m\""},
           Bad{"4 m", Quantity::number, "is a length; a plain number is expected", ""},
           Bad{"4 m^2", Quantity::length, "has another dimension; a length is expected (m)", ""},
           Bad{"10 Mpa", Quantity::pressure,
               "has an unknown unit \"Mpa\"; a pressure is expected (Pa)", "did you mean \"MPa\"?"},
           Bad{"10 blub", Quantity::time, "has an unknown unit \"blub\"; a time is expected (s)",
               ""},
           Bad{"cm", Quantity::length, "is not a number and a unit; a length is expected (m)", ""},
           Bad{"", Quantity::length, "is not a number and a unit; a length is expected (m)", ""},
           Bad{"nan m", Quantity::length, "is not a number and a unit; a length is expected (m)",
               ""},
           Bad{"1e999 m", Quantity::length, "is not a number and a unit; a length is expected (m)",
               ""},
           Bad{"4,5 cm", Quantity::length, "is not a number and a unit; a length is expected (m)",
               ""},
           // UDUNITS-2 would take these for 30 m, m and 1/m, and kg.
           Bad{"10 m 3", Quantity::length, "is not a number and a unit; a length is expected (m)",
               ""},
           Bad{"4 s", Quantity::velocity, "is a time; a velocity is expected (m/s)", ""},
           Bad{"4 1/m", Quantity::length, "has another dimension; a length is expected (m)", ""},
           Bad{"45 deg", Quantity::number, "is an angle; a plain number is expected", ""},
           Bad{"3 m @ 2", Quantity::length, "is not a number and a unit; a length is expected (m)",
               ""},
       }) {
    Conversion const result = to_si(text, quantity);
    EXPECT_FALSE(result.value.has_value()) << text;
    EXPECT_EQ(result.rule, rule) << text;
    EXPECT_EQ(result.hint, hint) << text;
  }
}

// Dimensions that case files do not hold.
TEST(Units, ConvertsAnyOtherDimension) {
  Dimension const impulse{"an impulse per area", "Pa s", {"Pa s", "kPa ms"}};
  EXPECT_EQ(to_si("3 kPa ms", impulse).value, 3.0);
  EXPECT_NEAR(*to_si("1 psi s", impulse).value, 6894.757293168, 1e-8);
  EXPECT_EQ(to_si("3 kPa", impulse).rule, "is a pressure; an impulse per area is expected (Pa s)");
  EXPECT_EQ(to_si("3 kPa m", impulse).rule,
            "has another dimension; an impulse per area is expected (Pa s)");
  EXPECT_EQ(to_si("3 kpa ms", impulse).hint, "did you mean \"kPa ms\"?");
}

TEST(Units, PrintsNothing) {
  testing::internal::CaptureStderr();
  to_si("10 blub", Quantity::length);
  to_si("4 m @", Quantity::length);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Units, EveryUsualUnitIsOfItsQuantity) {
  for (std::size_t i = 0; i < quantity_count; ++i) {
    auto const quantity = static_cast<Quantity>(i);
    for (auto const unit : info(quantity).usual)
      if (!unit.empty()) {
        EXPECT_TRUE(to_si("1 " + std::string(unit == "1" ? "" : unit), quantity).value) << unit;
      }
    std::string const unit = quantity == Quantity::number ? "" : std::string(info(quantity).unit);
    std::string const si = "1 " + unit;
    EXPECT_EQ(to_si(si, quantity).value, 1.0) << si;
  }
}

}  // namespace
}  // namespace moraine
