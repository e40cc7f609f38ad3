#include "blast/front.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "blast/kingery_bulmash.hpp"
#include "blast/scales.hpp"
#include "exact/hugoniot.hpp"

namespace moraine::blast {
namespace {

constexpr Air air{standard_pressure, standard_density};

// Mass and momentum across the front, and the density that the energy gives.
TEST(Front, ObeysTheJumpConditions) {
  for (double const p : {1e2, 1e4, 1e5, 1e6, 1e7}) {
    double const front = front_speed(p, air), u = particle_speed(p, air);
    EXPECT_NEAR(air.density * front * u, p, 1e-12 * p);
    double const ratio = (6.0 * p + 7.0 * air.pressure) / (p + 7.0 * air.pressure);
    EXPECT_NEAR(front / (front - u), ratio, 1e-12 * ratio);
    double const q = 0.5 * air.density * ratio * u * u;
    EXPECT_NEAR(dynamic_pressure(p, air), q, 1e-12 * q);
  }
}

// The shock of the engine's ideal gas, driven by a piston.
TEST(Front, AgreesWithTheHugoniotOfTheIdealGas) {
  IdealGas gas{};
  double const e = air.pressure / (0.4 * air.density);
  for (double const u : {10.0, 300.0, 2000.0}) {
    ShockState const shock = shock_from_piston(gas, air.density, e, u);
    double const p = shock.pressure - air.pressure;
    EXPECT_NEAR(front_speed(p, air), shock.shock_speed, 1e-9 * shock.shock_speed);
    EXPECT_NEAR(particle_speed(p, air), u, 1e-9 * u);
  }
}

TEST(Front, WeakFrontsAreSound) {
  EXPECT_NEAR(front_speed(1e-3, air), air.sound_speed(), 1e-5);
  EXPECT_NEAR(air.sound_speed(), 340.29, 0.01);  // ICAO standard atmosphere
}

TEST(NormalReflection, LiesBetweenTwoAndEight) {
  EXPECT_NEAR(normal_reflection(1e-3, 1e5) / 1e-3, 2.0, 1e-7);
  EXPECT_NEAR(normal_reflection(1e12, 1e5) / 1e12, 8.0, 1e-5);
  double last = 2.0;
  for (double p = 1.0; p < 1e10; p *= 1.3) {
    double const ratio = normal_reflection(p, 1e5) / p;
    EXPECT_GT(ratio, last);
    EXPECT_LT(ratio, 8.0);
    last = ratio;
  }
}

// The gas between wall and reflected front is at rest: the same jump, once more, into the stream.
TEST(NormalReflection, StopsTheStream) {
  for (double const p : {1e3, 1e5, 3e6}) {
    double const behind_density =
        air.density * (6.0 * p + 7.0 * air.pressure) / (p + 7.0 * air.pressure);
    Air const behind{air.pressure + p, behind_density};
    double const rise = normal_reflection(p, air.pressure) - p;
    EXPECT_NEAR(particle_speed(rise, behind), particle_speed(p, air),
                1e-10 * particle_speed(p, air));
  }
}

// Air is an ideal gas up to about 40 times the ambient pressure: 12 % of the measured reflection.
TEST(NormalReflection, AgreesWithKingeryBulmashUpToFortyTimes) {
  for (double z = 0.5; z < 30.0; z *= 1.1) {
    double const p = kingery_overpressure(Burst::free_air, z);
    double const measured = kingery_reflected_overpressure(Burst::free_air, z);
    if (p > 40.0 * air.pressure) continue;
    EXPECT_NEAR(normal_reflection(p, air.pressure), measured, 0.12 * measured) << z;
  }
}

}  // namespace
}  // namespace moraine::blast
