#include "blast/oblique_reflection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/bisect.hpp"
#include "blast/front.hpp"
#include "blast/oblique_shock.hpp"

namespace moraine::blast {
namespace {

constexpr double degree = std::numbers::pi / 180.0, air = 101325.0;

// NACA 1135, chart and tables: M = 2, shock angle 40 degrees: deflection 10.62 degrees.
TEST(ObliqueShock, AgreesWithTables) {
  double const normal = 2.0 * std::sin(40.0 * degree);
  double const ratio = strongest_ratio(normal * normal);
  EXPECT_NEAR(ratio, 1.7614, 1e-4);
  EXPECT_NEAR(deflection(ratio, 4.0) / degree, 10.62, 0.01);
  // Behind a normal shock at M = 2: 0.57735.
  EXPECT_NEAR(std::sqrt(mach_squared_behind(strongest_ratio(4.0), 4.0)), 0.57735, 1e-5);
  EXPECT_NEAR(deflection(strongest_ratio(4.0), 4.0), 0.0, 1e-9);
  // Greatest deflection at M = 2: 22.974 degrees.
  EXPECT_NEAR(deflection(detachment_ratio(4.0), 4.0) / degree, 22.974, 0.001);
}

TEST(RegularReflection, HeadOnIsNormal) {
  for (double const p : {1e2, 1e5, 1e6, 1e8}) {
    double const normal = normal_reflection(p, air);
    EXPECT_EQ(regular_reflection(p, air, 0.0), normal);
    EXPECT_NEAR(*regular_reflection(p, air, 1e-4), normal, 1e-6 * normal) << p;
  }
}

// Sound is doubled at any angle.
TEST(RegularReflection, WeakFrontsDouble) {
  for (double const angle : {5.0, 30.0, 60.0, 80.0})
    EXPECT_NEAR(*regular_reflection(1e-6 * air, air, angle * degree) / (1e-6 * air), 2.0, 1e-4)
        << angle;
}

// The flow behind two fronts follows the wall: checked in the laboratory frame, where each front
// adds a velocity along its normal.
TEST(RegularReflection, LeavesNoFlowThroughTheWall) {
  for (double const p : {2e4, 2e5, 2e6})
    for (double const angle : {15.0 * degree, 30.0 * degree, 38.0 * degree}) {
      auto const reflected = regular_reflection(p, air, angle);
      ASSERT_TRUE(reflected);
      double const density = 1.225;
      Air const ahead{air, density};
      double const behind_density = density * (6.0 * p + 7.0 * air) / (p + 7.0 * air);
      Air const behind{air + p, behind_density};
      double const u1 = particle_speed(p, ahead);
      double const trace = front_speed(p, ahead) / std::sin(angle);
      double const u2 = particle_speed(*reflected - p, behind);
      double const speed = front_speed(*reflected - p, behind);
      // The reflected front, inclined by b to the wall, runs into the stream u1 and keeps up with
      // the trace: speed = (trace - u1 sin a) sin b + u1 cos a cos b. It stops u1 cos a = u2 cos b.
      double const cos_b = u1 * std::cos(angle) / u2;
      double const sin_b = std::sqrt(1.0 - cos_b * cos_b);
      EXPECT_NEAR((trace - u1 * std::sin(angle)) * sin_b + u1 * std::cos(angle) * cos_b, speed,
                  1e-6 * speed)
          << p << " " << angle / degree;
    }
}

TEST(ExtremeAngle, OfStrongAndWeakFronts) {
  // Very strong fronts: 39.97 degrees for gamma = 1.4 (Courant, Friedrichs, Supersonic Flow and
  // Shock Waves (1948), section 131).
  EXPECT_NEAR(extreme_angle(1e7 * air, air) / degree, 39.97, 0.01);
  EXPECT_GT(extreme_angle(1e-4 * air, air) / degree, 88.0);
  // The least of all angles, near an overpressure of 7 times the ambient pressure.
  double least = 90.0;
  for (double p = 0.01 * air; p < 1e4 * air; p *= 1.1)
    least = std::min(least, extreme_angle(p, air) / degree);
  EXPECT_NEAR(least, 39.23, 0.02);
}

TEST(RegularReflection, EndsAtTheExtremeAngle) {
  for (double const p : {1e4, 1e5, 1e6}) {
    double const limit = extreme_angle(p, air);
    EXPECT_TRUE(regular_reflection(p, air, limit - 1e-9));
    EXPECT_FALSE(regular_reflection(p, air, limit + 1e-9));
  }
}

// Where two-shock theory gives the pressure of a normal shock at the same Mach number (mechanical
// equilibrium), the stem has no length to grow: three-shock theory starts there at path angle zero.
TEST(MachReflection, StartsAtMechanicalEquilibrium) {
  for (double const mach : {2.5, 3.0, 5.0}) {
    double const p = (strongest_ratio(mach * mach) - 1.0) * air;
    auto const excess = [&](double angle) {
      double const ahead = mach * mach / (std::sin(angle) * std::sin(angle));
      return *regular_reflection(p, air, angle) - (strongest_ratio(ahead) - 1.0) * air;
    };
    double const equilibrium = bisect(excess, 20.0 * degree, extreme_angle(p, air) - 1e-9);
    auto const stem = mach_reflection(p, air, equilibrium + 0.01 * degree);
    ASSERT_TRUE(stem) << mach;
    EXPECT_LT(stem->path_angle, 0.05 * degree) << mach;
    EXPECT_NEAR(stem->overpressure, *regular_reflection(p, air, equilibrium),
                2e-3 * stem->overpressure);
    EXPECT_FALSE(mach_reflection(p, air, equilibrium - 0.05 * degree)) << mach;
  }
}

// The stem is stronger than the incident front and weakens towards grazing incidence.
TEST(MachReflection, WeakensTowardsGrazing) {
  double const p = 10.0 * air;
  double last = 10.0;
  for (double angle = 45.0; angle <= 75.0; angle += 5.0) {
    auto const stem = mach_reflection(p, air, angle * degree);
    ASSERT_TRUE(stem) << angle;
    EXPECT_GT(stem->overpressure, p);
    EXPECT_LT(stem->overpressure / p, last);
    EXPECT_GT(stem->path_angle, 0.0);
    last = stem->overpressure / p;
  }
}

}  // namespace
}  // namespace moraine::blast
