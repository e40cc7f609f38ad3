#include "matter/eos/eos.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace moraine {
namespace {

struct State {
  double density;
  double energy;
};

std::vector<State> grid(std::vector<double> const& densities, std::vector<double> const& energies) {
  std::vector<State> states;
  for (double const rho : densities)
    for (double const e : energies) states.push_back({rho, e});
  return states;
}

struct LawStates {
  Eos eos;
  std::vector<State> states;  // above any floor, none at a kink
};

std::vector<LawStates> all_laws() {
  return {
      {Tait{}, grid({900, 1000, 1010, 1300}, {0.0, 500.0})},
      {Tait{.exponent = 1.4}, grid({900, 1000, 1300}, {0.0})},
      {Tait{.exponent = 1.0, .background_pressure = 1e5}, grid({900, 1000, 1300}, {0.0})},
      {WaterPolynomial{}, grid({1001, 1050, 1300, 1700}, {-20.0, 0.0, 357.1, 1e5, 2e6})},
      {WaterPolynomial{.cavitation_pressure = -1e9}, grid({850, 999}, {0.0, 357.1, 1e5})},
      {Jwl{}, grid({1, 50, 400, 1000, 1630, 2300}, {1e5, 1e6, 4.29e6, 8e6})},
      {IdealGas{}, grid({0.01, 1.225, 8}, {1e3, 2e5, 1e7})},
      {MieGrueneisen{}, grid({1001, 1050, 1300, 1700}, {-20.0, 0.0, 1e5, 2e6})},
      {MieGrueneisen{.least_pressure = -2e9}, grid({500, 850, 999}, {0.0, 300.0, 1e5})},
      {MieGrueneisen{1450.0, 1440.0, 1.6, 0.11, 0.2876, -0.267e6},  // loose sand
       grid({1451, 1600, 2200}, {0.0, 0.2876, 1e6})},
      {UsUp{}, grid({1001, 1050, 1300, 2200}, {-20.0, 0.0, 1e5, 2e6})},
      {UsUp{.least_pressure = -2e9}, grid({500, 850, 999}, {0.0, 300.0, 1e5})},
      {UsUp{.hugoniot_slope = 0.0, .grueneisen_coefficient = 1.2, .least_pressure = -1e10},
       grid({700, 850, 1001, 1500}, {0.0, 300.0, 1e5})},
      {Linear{}, grid({700, 1000, 1300}, {0.0, 300.0})},
      {PAlpha{}, grid({1700, 1900, 2400, 2800}, {0.0, 300.0, 1e4})},
      {PAlpha{.elastic_limit = 1e6, .least_pressure = -1e6}, grid({1680, 2000}, {0.0, 300.0})},
  };
}

// c^2 = dp/drho + (p / rho^2) dp/de with the derivatives by central differences. With steps of 1e-6
// the truncation is about 1e-11 of the slope, and rounding in p costs up to p eps / (1e-6 rho)
// against the slope: 1e-7 holds for both with a margin.
TEST(Eos, SoundSpeedMatchesDifferencesOfPressure) {
  for (auto const& [eos, states] : all_laws()) {
    std::visit(
        [&states = states](auto const& law) {
          for (auto const& [rho, e] : states) {
            double const d_rho = 1e-6 * rho;
            double const d_e = 1e-6 * std::max(std::fabs(e), 1e5);
            double const p_rho =
                (law.pressure(rho + d_rho, e) - law.pressure(rho - d_rho, e)) / (2 * d_rho);
            double const p_e =
                (law.pressure(rho, e + d_e) - law.pressure(rho, e - d_e)) / (2 * d_e);
            double const expected = p_rho + law.pressure(rho, e) / (rho * rho) * p_e;
            EXPECT_NEAR(law.sound_speed_squared(rho, e), expected, 1e-7 * std::fabs(expected))
                << law.name << " at rho " << rho << ", e " << e;
          }
        },
        eos);
  }
}

TEST(Eos, RespondGivesPressureAndSignedSoundSpeed) {
  for (auto const& [eos, states] : all_laws()) {
    std::visit(
        [&states = states](auto const& law) {
          for (auto const& [rho, e] : states) {
            StateResponse const response = law.respond(rho, e);
            double const p = law.pressure(rho, e);
            // Tait: two ways to write the same sum, whose terms are as large as the stiffness.
            EXPECT_NEAR(response.pressure, p, 1e-15 * (std::fabs(p) + 1e10)) << law.name;
            EXPECT_DOUBLE_EQ(response.sound_speed, law.sound_speed(rho, e)) << law.name;
            EXPECT_DOUBLE_EQ(response.sound_speed * std::fabs(response.sound_speed),
                             law.sound_speed_squared(rho, e))
                << law.name;
          }
        },
        eos);
  }
}

// The inverses are exact but for the rounding of p, which the slope carries over to the argument.
TEST(Eos, InversesReturnToTheState) {
  for (auto const& [eos, states] : all_laws()) {
    std::visit(
        [&states = states](auto const& law) {
          for (auto const& [rho, e] : states) {
            double const p = law.pressure(rho, e);
            EXPECT_NEAR(law.density_at_pressure(p, e), rho, 1e-12 * rho)
                << law.name << " at rho " << rho << ", e " << e;
            if (law.pressure(rho, e + 1e6) != p) {  // energy has an effect
              EXPECT_NEAR(law.pressure(rho, law.energy_at_pressure(rho, p)), p,
                          1e-13 * (std::fabs(p) + 1e9))
                  << law.name << " at rho " << rho << ", e " << e;
            }
          }
        },
        eos);
  }
}

TEST(Eos, ListGivesReferenceStateAndName) {
  EXPECT_EQ(eos_name(Tait{}), "tait");
  EXPECT_EQ(eos_name(WaterPolynomial{}), "water_polynomial");
  EXPECT_EQ(eos_name(Jwl{}), "jwl");
  EXPECT_EQ(eos_name(IdealGas{}), "ideal_gas");
  EXPECT_EQ(eos_name(MieGrueneisen{}), "mie_grueneisen");
  EXPECT_EQ(eos_name(UsUp{}), "us_up");
  EXPECT_EQ(eos_name(Linear{}), "linear");
  EXPECT_EQ(eos_name(PAlpha{}), "p_alpha");
  EXPECT_EQ(reference_density(Jwl{}), 1630.0);
  EXPECT_EQ(reference_energy(Jwl{}), 4.29e6);
}

TEST(SignedRoot, MarksNegativeSquares) {
  EXPECT_EQ(signed_root(4.0), 2.0);
  EXPECT_EQ(signed_root(0.0), 0.0);
  EXPECT_EQ(signed_root(-9.0), -3.0);
}

TEST(Tait, ReferenceState) {
  Tait const water{.reference_sound_speed = 1480.0, .background_pressure = 101325.0};
  EXPECT_DOUBLE_EQ(water.sound_speed(1000.0, 0.0), 1480.0);
  EXPECT_DOUBLE_EQ(water.pressure(1000.0, 0.0), 101325.0);
  // (1.01^7 - 1) 1000 1480^2 / 7 + 101325, by hand with 1.01^7 = 1.07213535210701.
  EXPECT_NEAR(water.pressure(1010.0, 0.0), 0.07213535210701 * 1000 * 1480.0 * 1480.0 / 7 + 101325,
              1e-3);
  EXPECT_EQ(water.pressure(1010.0, 0.0), water.pressure(1010.0, 1e6));
}

TEST(Tait, HasNoDensityBelowTheLeastPressure) {
  Tait const water{};
  EXPECT_TRUE(std::isnan(water.density_at_pressure(-1.001 * water.stiffness(), 0.0)));
  EXPECT_GT(water.density_at_pressure(-0.999 * water.stiffness(), 0.0), 0.0);
}

// Liu and Liu's constants: the values follow from the law by hand.
TEST(WaterPolynomial, ReferenceStates) {
  WaterPolynomial const water{};
  EXPECT_NEAR(water.pressure(1000.0, 357.1), 0.4934 * 1000 * 357.1, 1e-6);  // 176 kPa
  EXPECT_NEAR(water.pressure(1000.0, 205.4), 101325.0, 25.0);               // 205.4 has four digits
  EXPECT_NEAR(water.sound_speed(1000.0, 0.0), std::sqrt(2.19e6), 1e-9);
  EXPECT_NEAR(water.sound_speed(1000.0, 357.1), 1480.0, 0.1);
}

TEST(WaterPolynomial, CompressionAndTensionMeetAtTheReferenceDensity) {
  WaterPolynomial const water{.cavitation_pressure = -1e9};
  StateResponse const below = water.respond(1000.0 * (1 - 1e-12), 357.1);
  StateResponse const above = water.respond(1000.0 * (1 + 1e-12), 357.1);
  EXPECT_NEAR(below.pressure, above.pressure, 1e-2);  // slope 2.2e6 times 2e-9, plus rounding
  EXPECT_NEAR(below.sound_speed, above.sound_speed, 1e-6);
}

TEST(WaterPolynomial, FloorFreezesPressureAndSoundSpeed) {
  for (double const floor : {0.0, -5e6, 3e5}) {
    WaterPolynomial const water{.cavitation_pressure = floor};
    for (double const e : {-1e5, -100.0, 0.0, 357.1, 1e5}) {
      double const met = water.density_at_pressure(floor, e);
      double const c = water.sound_speed(met * (1 + 1e-12), e);
      ASSERT_GT(c, 1000.0);
      for (double const part : {0.999999, 0.9, 0.1, 0.001}) {
        StateResponse const cavity = water.respond(part * met, e);
        EXPECT_EQ(cavity.pressure, floor) << "e " << e;
        EXPECT_NEAR(cavity.sound_speed, c, 1e-6 * c) << "e " << e << ", rho " << part * met;
      }
    }
  }
}

TEST(WaterPolynomial, InvalidStatesHaveNegativeSoundSpeedAndNeverNaN) {
  WaterPolynomial const water{.cavitation_pressure = -1e9};
  // Above the floor: at e = -1.9e6 J/kg the pressure falls as the density rises.
  StateResponse const free = water.respond(999.0, -1.9e6);
  EXPECT_GT(free.pressure, -1e9);
  EXPECT_LT(free.sound_speed, 0.0);
  // At a floor that is met nowhere.
  StateResponse const floored = WaterPolynomial{}.respond(900.0, -1.9e6);
  EXPECT_EQ(floored.pressure, 0.0);
  EXPECT_LT(floored.sound_speed, 0.0);
}

TEST(WaterPolynomial, InversesSayWhereThereIsNoState) {
  WaterPolynomial const water{};
  EXPECT_TRUE(std::isnan(water.density_at_pressure(-1.0, 0.0)));
  EXPECT_TRUE(std::isnan(water.density_at_pressure(1e6, -2e6)));
  EXPECT_TRUE(std::isnan(water.energy_at_pressure(1000.0, -1.0)));
  EXPECT_TRUE(std::isnan(water.energy_at_pressure(600.0, 1e6)));
}

// Values published with the case: p = 8.38e9 Pa and c = 4080 m/s, both to three digits.
TEST(Jwl, TntAtReferenceState) {
  Jwl const tnt{};
  StateResponse const response = tnt.respond(1630.0, 4.29e6);
  EXPECT_NEAR(response.pressure, 8.38e9, 0.005e9);
  EXPECT_NEAR(response.sound_speed, 4080.0, 5.0);
}

TEST(Jwl, BecomesAnIdealGasWhenExpanded) {
  Jwl const tnt{};
  StateResponse const response = tnt.respond(1.0, 1e6);
  // The exponentials are exp(-0.95 1630) and below: zero.
  EXPECT_DOUBLE_EQ(response.pressure, 0.3 * 1.0 * 1e6);
  EXPECT_NEAR(response.sound_speed, std::sqrt(1.3 * 0.3 * 1e6), 1e-9);
}

TEST(Jwl, DensityInverseSaysWhereThereIsNoState) {
  Jwl const tnt{};
  EXPECT_TRUE(std::isnan(tnt.density_at_pressure(0.0, 4.29e6)));
  EXPECT_TRUE(std::isnan(tnt.density_at_pressure(1e13, 4.29e6)));
  EXPECT_NEAR(tnt.density_at_pressure(1e5, 4.29e6), 1e5 / (0.3 * 4.29e6), 1e-9);
}

TEST(IdealGas, ReferenceStateIsAir) {
  IdealGas const air{};
  StateResponse const response = air.respond(air.reference_density, air.reference_energy);
  EXPECT_NEAR(response.pressure, 101325.0, 1e-3);
  EXPECT_NEAR(response.sound_speed, 340.29, 0.01);  // ISA at sea level
  EXPECT_LT(air.sound_speed(1.0, -1.0), 0.0);
  EXPECT_TRUE(std::isnan(air.density_at_pressure(1e5, -1.0)));
  EXPECT_TRUE(std::isnan(air.density_at_pressure(1e5, 0.0)));
}

}  // namespace
}  // namespace moraine
