#include "output/balances.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moraine {
namespace {

/// Two rows of sums: at rest, and after 2 s of free fall of 3 kg, 10 J of heat from a wall that
/// worked 10 J, and 1 J that nobody knows of.
Table falling() {
  Table t;
  auto const add = [&](char const* name, double start, double end) {
    t.columns.push_back({name, ""});
    t.values.push_back({start, end});
  };
  double const fall = 0.5 * 3.0 * 400.0;  // m v^2 / 2 with v = g t = 20 m/s
  add("time", 0.0, 2.0);
  add("kinetic_energy", 0.0, fall);
  add("internal_energy", 100.0, 111.0);
  add("potential_energy", 1000.0, 1000.0 - fall);
  add("total_energy", 1100.0, 1111.0);
  add("lost_energy", 0.0, 0.0);
  add("wall_work", 0.0, 10.0);
  add("damping_work", 0.0, 0.0);
  add("detonation_energy", 0.0, 0.0);
  add("drift_work", 0.0, 0.0);
  add("mass", 3.0, 3.0);
  for (char const* const axis : {"x", "y", "z"}) {
    bool const down = *axis == 'y';
    add((std::string("momentum_") + axis).c_str(), 0.0, down ? -59.0 : 0.0);
    add((std::string("wall_impulse_") + axis).c_str(), 0.0, 0.0);
  }
  return t;
}

TEST(Balances, TellEnergyThatNobodyBooked) {
  auto const drift = energy_drift(falling());
  ASSERT_TRUE(drift);
  EXPECT_NEAR(drift->largest, 1.0, 1e-12);
  EXPECT_NEAR(drift->scale, 600.0, 1e-12);
  EXPECT_NEAR(drift->share(), 1.0 / 600.0, 1e-15);
}

// Gravity gave -60 kg m/s, of which 1 is missing; sqrt(2 m E) = sqrt(2 3 600) = 60 kg m/s.
TEST(Balances, TellMomentumThatNobodyGave) {
  auto const drift = momentum_drift(falling(), {0.0, -10.0, 0.0});
  ASSERT_TRUE(drift);
  EXPECT_NEAR(drift->largest, 1.0, 1e-12);
  EXPECT_NEAR(drift->scale, 60.0, 1e-12);
}

TEST(Balances, AreSilentWithoutTheirColumns) {
  EXPECT_FALSE(energy_drift(Table{}));
  EXPECT_FALSE(momentum_drift(Table{}, {}));
  EXPECT_FALSE(last_of(Table{}, "mass"));
  EXPECT_EQ(last_of(falling(), "time"), 2.0);
}

// One sum that is no number is enough, wherever it stands.
TEST(Balances, OfWhatIsNoNumberAreNone) {
  for (char const* const column : {"total_energy", "kinetic_energy", "wall_work", "momentum_x"}) {
    Table t = falling();
    for (std::size_t k = 0; k < t.columns.size(); ++k)
      if (t.columns[k].name == column) t.values[k].back() = std::nan("");
    bool const of_energy = std::string_view(column) != "momentum_x";
    if (of_energy) {
      EXPECT_TRUE(std::isnan(energy_drift(t)->share())) << column;
    }
    bool const of_momentum = !of_energy || std::string_view(column) == "kinetic_energy";
    if (of_momentum) {
      EXPECT_TRUE(std::isnan(momentum_drift(t, {})->share())) << column;
    }
  }
}

// Planes across y take what nobody books: that axis is not asked.
TEST(Balances, LeaveOutAxes) {
  auto const drift = momentum_drift(falling(), {0.0, -10.0, 0.0}, {true, false, true});
  ASSERT_TRUE(drift);
  EXPECT_EQ(drift->largest, 0.0);
}

TEST(Balances, ShareOfNothing) {
  EXPECT_EQ((Drift{0.0, 0.0}.share()), 0.0);
  EXPECT_TRUE(std::isinf(Drift{1.0, 0.0}.share()));
}

}  // namespace
}  // namespace moraine
