#include "exact/detonation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "unit/exact/integral.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

Explosive charge_of(Jwl const& law) { return {law, law.reference_density, law.reference_energy}; }

// Products that are an ideal gas: D^2 = 2 (gamma^2 - 1) e_0, rho = rho_0 (gamma+1)/gamma,
// p = rho_0 D^2 / (gamma+1); the rest zone reaches to D/2. Fickett and Davis (1979), section 2A.
TEST(Detonation, IdealGasInClosedForm) {
  for (double const gamma : {1.4, 2.0, 3.0}) {
    IdealGas law;
    law.heat_capacity_ratio = gamma;
    Explosive const charge{law, 1600.0, 4e6};
    TaylorWave const wave(charge);
    auto const& [speed, behind, sound_speed] = wave.detonation();
    double const expected = std::sqrt(2.0 * (gamma * gamma - 1.0) * 4e6);
    EXPECT_NEAR(speed / expected, 1.0, 1e-12);
    EXPECT_NEAR(behind.density, 1600.0 * (gamma + 1.0) / gamma, 1e-5);
    EXPECT_NEAR(behind.pressure * (gamma + 1.0) / (1600.0 * speed * speed), 1.0, 1e-8);
    EXPECT_NEAR(wave.rest_speed() / speed, 0.5, 1e-8);
  }
}

// The constants of the handbook give its detonation velocity and pressure, which they were fitted
// to: Dobratz and Crawford (1985). Our digits: computed apart, to a last unit.
TEST(Detonation, Tnt) {
  TaylorWave const wave(charge_of(Jwl{}));
  EXPECT_NEAR(wave.detonation().speed, 6930.0, 0.001 * 6930.0);
  EXPECT_NEAR(wave.detonation().behind.pressure, 21.0e9, 0.0025 * 21.0e9);
  Jwl liu;
  liu.b = 3.21e9;
  TaylorWave const other(charge_of(liu));
  EXPECT_NEAR(other.detonation().speed, 6927.789, 5e-3);
  EXPECT_NEAR(other.rest().pressure, 5.6341e9, 1e5);
  EXPECT_NEAR(other.rest_speed() / other.detonation().speed, 0.52203, 2e-5);
}

TEST(Detonation, ObeysTheJumpConditionsAndTouches) {
  Explosive const charge = charge_of(Jwl{});
  auto const [speed, behind, sound_speed] = chapman_jouguet(charge);
  EXPECT_NEAR(behind.density * (speed - behind.velocity), charge.density * speed,
              1e-10 * charge.density * speed);
  EXPECT_NEAR(behind.pressure, charge.density * speed * behind.velocity, 1e-10 * behind.pressure);
  EXPECT_NEAR(behind.specific_energy - charge.specific_energy,
              0.5 * behind.velocity * behind.velocity, 1e-10 * charge.specific_energy);
  EXPECT_NEAR(charge.products.pressure(behind.density, behind.specific_energy), behind.pressure,
              1e-10 * behind.pressure);
  EXPECT_NEAR(behind.velocity + sound_speed, speed, 1e-10 * speed);
}

// Behind the front is what was ahead of it; the wall has pushed with the pressure at rest; the
// energy is that of the explosive.
TEST(TaylorWave, ConservesMassMomentumAndEnergy) {
  Explosive const charge = charge_of(Jwl{});
  TaylorWave const wave(charge);
  double const front = wave.detonation().speed;
  auto const all = [&](auto const& density) {
    return integral([&](double s) { return density(wave.sample(s)); },
                    {0.0, wave.rest_speed(), front});
  };
  double const mass = charge.density * front;  // per second
  EXPECT_NEAR(all([](FlowState const& s) { return s.density; }), mass, 1e-10 * mass);
  double const push = wave.rest().pressure;
  EXPECT_NEAR(all([](FlowState const& s) { return s.density * s.velocity; }), push, 1e-10 * push);
  double const energy = mass * charge.specific_energy;
  EXPECT_NEAR(all([](FlowState const& s) {
                return s.density * (s.specific_energy + 0.5 * s.velocity * s.velocity);
              }),
              energy, 1e-10 * energy);
  EXPECT_EQ(wave.sample(front * 1.001).density, charge.density);
  EXPECT_EQ(wave.sample(0.0).velocity, 0.0);
}

TEST(Detonation, RefusesWhatCannotDetonate) {
  EXPECT_EQ(message_of<std::invalid_argument>([] {
              chapman_jouguet({IdealGas{}, 1600.0, 0.0});
            }),
            "detonation: the products have no pressure at the solid's density");
  // A liquid without energy in its pressure has no products.
  EXPECT_NE(message_of<std::domain_error>([] {
              Tait law;
              law.background_pressure = 1e5;
              chapman_jouguet({law, 1000.0, 0.0});
            }),
            "");
}

}  // namespace
}  // namespace moraine
