// Both forms of Mie-Grueneisen, and the linear law: shock curves, tension, floors.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/hugoniot.hpp"
#include "matter/eos/eos.hpp"

namespace moraine {
namespace {

constexpr UsUp copper{8930.0, 3940.0, 1.489, 1.99};
constexpr MieGrueneisen sand{1450.0, 1440.0, 1.6, 0.11};

TEST(UsUp, ShocksFollowTheLine) {
  for (UsUp const& law : {copper, UsUp{}, UsUp{.hugoniot_slope = 0.0}})
    for (double const u : {1.0, 30.0, 500.0, 1400.0}) {
      ShockState const shock = shock_from_piston(law, law.reference_density, 0.0, u);
      double const line = law.reference_sound_speed + law.hugoniot_slope * u;
      // The shock speed is u / compression: bisection ends at the last bit of the compression, but
      // rounding of the pressure moves that by about 1e-16 c / u.
      EXPECT_NEAR(shock.shock_speed, line, 1e-9 * line) << "u " << u;
    }
}

// By hand for s = 1.489, eta = 0.2: 8930 3940^2 0.2 / (1 - 0.2978)^2 = 5.6228e10 Pa.
TEST(UsUp, PressureByHand) {
  double const rho = 8930.0 / 0.8;
  double const shock = 8930.0 * 3940.0 * 3940.0 * 0.2 / (0.7022 * 0.7022);
  EXPECT_NEAR(shock, 5.6228e10, 1e6);
  EXPECT_NEAR(copper.pressure(rho, 1e5), shock * (1.0 - 0.199) + 1.99 * 8930.0 * 1e5, 1.0);
}

TEST(UsUp, EndsWhereNoShockReaches) {
  double const limit = copper.limiting_density();
  EXPECT_NEAR(1.0 - copper.reference_density / limit, 1.0 / 1.489, 1e-12);
  EXPECT_GT(copper.sound_speed(0.999 * limit, 0.0), 0.0);
  for (double const rho : {limit, 1.2 * limit, 100.0 * limit}) {
    StateResponse const response = copper.respond(rho, 1e5);
    EXPECT_LT(response.sound_speed, 0.0);
    EXPECT_TRUE(std::isfinite(response.pressure)) << "and no NaN";
  }
  EXPECT_TRUE(std::isinf((UsUp{.hugoniot_slope = 1.0}.limiting_density())));
  EXPECT_TRUE(std::isinf((UsUp{.hugoniot_slope = 0.0}.limiting_density())));
  EXPECT_EQ(limiting_density(Eos(copper)), limit);
  EXPECT_TRUE(std::isinf(limiting_density(Eos(Tait{}))));
  EXPECT_TRUE(std::isnan(copper.energy_at_pressure(limit, 1e9)));
}

// c_0^2 (rho - rho_0) rho_0 / rho with s = 0 and Gamma_0 = 0: the water of tanks.
TEST(UsUp, WithoutSlopeIsStraightInVolume) {
  UsUp const water{.reference_density = 1000.0,
                   .reference_sound_speed = 1480.0,
                   .hugoniot_slope = 0.0,
                   .grueneisen_coefficient = 0.0,
                   .least_pressure = -std::numeric_limits<double>::infinity()};
  for (double const rho : {800.0, 1000.0, 1200.0})
    EXPECT_NEAR(water.pressure(rho, 7.0), 1000.0 * 1480.0 * 1480.0 * (1.0 - 1000.0 / rho), 1e-5);
  EXPECT_EQ(water.energy_at_pressure(1200.0, 0.0), water.reference_energy);
}

TEST(MieGrueneisen, ShocksFollowTheCubicCurve) {
  for (double const u : {1.0, 30.0, 300.0, 1000.0}) {
    ShockState const shock = shock_from_piston(sand, 1450.0, 0.0, u);
    double const mu = shock.density / 1450.0 - 1.0;
    double const a0 = 1450.0 * 1440.0 * 1440.0;
    double const p_h = a0 * mu * (1.0 + mu * (2.2 + mu * 2.28));
    EXPECT_NEAR(shock.pressure, p_h, 1e-8 * p_h) << "u " << u;
  }
}

// The cubic curve has the first three terms of U_s = C + S u_p: its shock speed is off by the third
// power of the particle velocity.
TEST(MieGrueneisen, ShocksApproachTheLine) {
  auto const off = [](double u) {
    return shock_from_piston(sand, 1450.0, 0.0, u).shock_speed - (1440.0 + 1.6 * u);
  };
  EXPECT_NEAR(off(40.0) / off(20.0), 8.0, 0.5);
  EXPECT_LT(std::fabs(off(40.0)), 0.1);
}

TEST(MieGrueneisen, BothFormsAreTangentAtRest) {
  UsUp const closed{1450.0, 1440.0, 1.6, 0.11};
  for (double const part : {1.0 - 1e-9, 1.0 + 1e-9}) {
    EXPECT_NEAR(sand.sound_speed(1450.0 * part, 0.0), 1440.0, 1e-4);
    EXPECT_NEAR(closed.sound_speed(1450.0 * part, 0.0), 1440.0, 1e-4);
  }
}

/// Pressure and sound speed below the density at which the floor is met at the same energy.
template <class Law>
void expect_frozen(Law const& law, double floor, double e) {
  double const met = law.density_at_pressure(floor, e);
  double const c = law.sound_speed(met * (1 + 1e-12), e);
  ASSERT_GT(c, 500.0);
  for (double const part : {0.999999, 0.9, 0.1, 0.001}) {
    StateResponse const torn = law.respond(part * met, e);
    EXPECT_EQ(torn.pressure, floor) << "e " << e;
    EXPECT_NEAR(torn.sound_speed, c, 1e-6 * c) << "e " << e << ", rho " << part * met;
  }
}

TEST(Floors, FreezePressureAndSoundSpeed) {
  for (double const floor : {0.0, -0.267e6, -5e6, 3e5})
    for (double const e : {-100.0, 0.0, 0.2876, 1e5}) {
      expect_frozen(MieGrueneisen{1450.0, 1440.0, 1.6, 0.11, 0.0, floor}, floor, e);
      expect_frozen(UsUp{1450.0, 1440.0, 1.6, 0.11, 0.0, floor}, floor, e);
      expect_frozen(Linear{.least_pressure = floor}, floor, e);
    }
}

// Without a floor the cubic form loses its sound speed deep in tension, below a tenth of rho_0 for
// a soil: the reason for floors.
TEST(Floors, AreNeededDeepInTension) {
  MieGrueneisen free = sand;
  free.least_pressure = -std::numeric_limits<double>::infinity();
  EXPECT_GT(free.sound_speed(0.15 * 1450.0, 0.0), 0.0);
  StateResponse const torn = free.respond(0.05 * 1450.0, 0.0);
  EXPECT_LT(torn.sound_speed, 0.0);
  EXPECT_TRUE(std::isfinite(torn.pressure));
  EXPECT_GT(sand.sound_speed(0.05 * 1450.0, 0.0), 1000.0) << "with a floor";
}

TEST(Floors, HaveNoStateBelow) {
  EXPECT_TRUE(std::isnan(sand.density_at_pressure(-1.0, 0.0)));
  EXPECT_TRUE(std::isnan(sand.energy_at_pressure(1450.0, -1.0)));
  EXPECT_TRUE(std::isnan(copper.density_at_pressure(-1.0, 0.0)));
  EXPECT_TRUE(std::isnan(copper.energy_at_pressure(8930.0, -1.0)));
  EXPECT_TRUE(std::isnan((Linear{.least_pressure = 0.0}.density_at_pressure(-1.0, 0.0))));
  EXPECT_TRUE(std::isnan(Linear{}.density_at_pressure(-3e9, 0.0))) << "no such density";
  // Energies so low that pressure falls with density: the floor is met nowhere.
  EXPECT_LT(sand.sound_speed(1400.0, -2e8), 0.0);
}

TEST(Linear, IsALine) {
  Linear const law{.reference_sound_speed = 30.0, .background_pressure = 1e5};
  EXPECT_DOUBLE_EQ(law.pressure(1001.0, 5.0), 1e5 + 900.0);
  EXPECT_EQ(law.sound_speed(700.0, 5.0), 30.0);
  EXPECT_DOUBLE_EQ(law.density_at_pressure(1e5 - 1800.0, 0.0), 998.0);
}

}  // namespace
}  // namespace moraine
