#include "exact/isentrope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "exact/riemann.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

// p ~ rho^gamma, w = 2 (c_0 - c)/(gamma - 1), down to a vacuum.
TEST(Isentrope, IdealGasInClosedForm) {
  for (double const gamma : {1.01, 1.4, 3.0}) {
    IdealGas law;
    law.heat_capacity_ratio = gamma;
    Isentrope const isentrope(law, 2.0, 5.0);
    double const p_0 = isentrope.start().pressure, c_0 = isentrope.start().sound_speed;
    EXPECT_EQ(isentrope.ends_by(), IsentropeEnd::vacuum);
    EXPECT_TRUE(isentrope.spreads(isentrope.end()));
    for (double const part : {0.9, 0.5, 0.1, 1e-3, 1e-9}) {
      IsentropeState const at = isentrope.at_pressure(part * p_0);
      EXPECT_NEAR(at.density / (2.0 * std::pow(part, 1.0 / gamma)), 1.0, 1e-11) << part;
      double const c = c_0 * std::pow(part, 0.5 * (gamma - 1.0) / gamma);
      EXPECT_NEAR(at.velocity_change, 2.0 * (c_0 - c) / (gamma - 1.0), 1e-11 * c_0 / (gamma - 1.0));
    }
    EXPECT_NEAR(isentrope.end().velocity_change, 2.0 * c_0 / (gamma - 1.0),
                1e-11 * c_0 / (gamma - 1.0));
    EXPECT_EQ(isentrope.end().density, 0.0);
  }
}

// Products become an ideal gas of gamma = 1 + omega: the velocity of escape does not depend on
// where the last step of the numbers ends. The slope of the pressure is rho c^2 / rho everywhere.
TEST(Isentrope, ProductsOfTnt) {
  Jwl const law;
  Isentrope const isentrope(law, law.reference_density, law.reference_energy);
  EXPECT_EQ(isentrope.ends_by(), IsentropeEnd::vacuum);
  IsentropeState const far = isentrope.at_pressure(1e-6);
  EXPECT_NEAR(isentrope.end().velocity_change,
              far.velocity_change + 2.0 * far.sound_speed / law.omega, 1e-7);
  for (double const p : {6e9, 1e9, 1e8, 1e6}) {
    IsentropeState const a = isentrope.at_pressure(1.0001 * p), b = isentrope.at_pressure(p),
                         c = isentrope.at_pressure(0.9999 * p);
    EXPECT_NEAR(b.pressure, p, 1e-11 * p);
    double const c2 = (a.pressure - c.pressure) / (a.density - c.density);
    EXPECT_NEAR(c2, b.sound_speed * b.sound_speed, 1e-6 * c2);
    double const heating = (a.specific_energy - c.specific_energy) / (a.density - c.density);
    EXPECT_NEAR(heating, b.pressure / (b.density * b.density), 1e-6 * heating);
  }
}

// Water expands to its floor and no further: where p = 0 on the isentrope.
TEST(Isentrope, EndsAtAFloorOfPressure) {
  WaterPolynomial const law;
  Isentrope const isentrope(law, 1200.0, 1e5);
  EXPECT_EQ(isentrope.ends_by(), IsentropeEnd::floor);
  EXPECT_EQ(isentrope.end().pressure, 0.0);
  WaterPolynomial free = law;
  free.cavitation_pressure = -1e12;
  IsentropeState const zero = Isentrope(free, 1200.0, 1e5).at_pressure(0.0);
  EXPECT_NEAR(isentrope.end().density, zero.density, 1e-9 * zero.density);
  EXPECT_NEAR(isentrope.end().velocity_change, zero.velocity_change, 1e-8);
}

/// A liquid that breaks at half of its density, where its pressure is least.
struct BrittleLiquid {
  double pressure(double rho, double) const {
    double const mu = rho / 1000.0 - 1.0;
    return 2e9 * (mu + mu * mu);
  }
  double sound_speed_squared(double rho, double) const {
    return 2e6 * (1.0 + 2.0 * (rho / 1000.0 - 1.0));
  }
};

TEST(Isentrope, EndsWhereThereIsNoSound) {
  Isentrope const isentrope(BrittleLiquid{}, 1100.0, 0.0);
  EXPECT_EQ(isentrope.ends_by(), IsentropeEnd::rupture);
  EXPECT_NEAR(isentrope.end().density, 500.0, 1e-3);
  EXPECT_EQ(message_of<std::invalid_argument>([] { Isentrope(BrittleLiquid{}, 400.0, 0.0); }),
            "isentrope: the state has no density or no sound speed");
}

/// A law whose sound speed falls with the square of the density: its rarefactions steepen.
struct AnomalousLiquid {
  double pressure(double rho, double) const {
    double const ratio = 1000.0 / rho;
    return 1000.0 * 4e6 / 3.0 * (1.0 - ratio * ratio * ratio);
  }
  double sound_speed_squared(double rho, double) const { return 4e6 * std::pow(1000.0 / rho, 4); }
};

TEST(Isentrope, KnowsWhereWavesSteepen) {
  Isentrope const anomalous(AnomalousLiquid{}, 1100.0, 0.0);
  EXPECT_FALSE(anomalous.spreads(anomalous.at_pressure(0.0)));
  EXPECT_TRUE(anomalous.spreads(anomalous.start()));
  RiemannSide const side{AnomalousLiquid{}, 1100.0, 0.0, 0.0};
  EXPECT_EQ(message_of<std::domain_error>([&] { RiemannProblem::into_vacuum(side); }),
            "wave: a rarefaction of this equation of state would steepen to a shock");
}

}  // namespace
}  // namespace moraine
