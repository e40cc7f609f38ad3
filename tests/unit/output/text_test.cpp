#include <gtest/gtest.h>

#include <chrono>

#include "output/si_prefix.hpp"
#include "output/timing_table.hpp"

namespace moraine {
namespace {

using namespace std::chrono_literals;

TEST(TimingTable, SortsAndAddsWhatIsMissing) {
  Timers timers;
  timers.record(timers.add("search"), 1s);
  timers.record(timers.add("momentum sweep"), 6s);
  timers.record(timers.add("search"), 1s);
  EXPECT_EQ(timing_table(timers, 10.0),
            "label              seconds       %       calls\n"
            "momentum sweep       6.000    60.0           1\n"
            "search               2.000    20.0           2\n"
            "other                2.000    20.0\n"
            "total               10.000   100.0\n");
}

TEST(DisplayUnit, ChoosesAPrefix) {
  EXPECT_EQ(display_unit("Pa", 2.5e8).unit, "MPa");
  EXPECT_EQ(display_unit("Pa", 1e9).unit, "GPa");
  EXPECT_DOUBLE_EQ(display_unit("Pa", 2.5e8).factor, 1e6);
  EXPECT_EQ(display_unit("J/kg", 4.29e6).unit, "MJ/kg");
  EXPECT_EQ(display_unit("s", 2e-6).unit, "µs");
  EXPECT_EQ(display_unit("s", 5000.0).unit, "s");
  EXPECT_EQ(display_unit("m", 0.3).unit, "cm");
  EXPECT_EQ(display_unit("m", 1.2).unit, "m");
  EXPECT_EQ(display_unit("m/s", 1480.0).unit, "m/s");
}

TEST(DisplayUnit, TakesAPowerOfTenWhereAPrefixWouldBeWrong) {
  EXPECT_EQ(display_unit("kg/m^3", 1000.0).unit, "kg/m³");
  EXPECT_EQ(display_unit("kg/m^3", 2.5e6).unit, "10⁶ kg/m³");
  EXPECT_EQ(display_unit("kg m/s", 2e-5).unit, "10⁻⁶ kg·m/s");
  EXPECT_EQ(display_unit("m^2", 1e6).unit, "10⁶ m²");
  EXPECT_EQ(display_unit("", 0.0).unit, "");
}

TEST(WithUnit, RoundsToSignificantDigits) {
  EXPECT_EQ(with_unit(0.0012345, "s"), "1.23 ms");
  EXPECT_EQ(with_unit(-250e6, "Pa"), "-250 MPa");
  EXPECT_EQ(with_unit(0.0, "s"), "0.00 s");
  EXPECT_EQ(with_prefix(84.21e6), "84.2 M");
  EXPECT_EQ(with_prefix(812.4), "812");
}

}  // namespace
}  // namespace moraine
