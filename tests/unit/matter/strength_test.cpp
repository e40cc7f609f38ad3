// Laws of strength: what their limits are, and how a stress turns.
#include "matter/strength/strength.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace moraine {
namespace {

Deviator random_deviator(std::mt19937& random, double size) {
  std::normal_distribution<double> normal(0.0, size);
  Deviator s{};
  for (double& number : s) number = normal(random);
  double const mean = (s[0] + s[1] + s[2]) / 3.0;
  for (std::size_t k = 0; k < 3; ++k) s[k] -= mean;
  return s;
}

/// Mohr and Coulomb's sigma_1 - sigma_3 + (sigma_1 + sigma_3) sin(phi) - 2 c cos(phi).
double mohr_coulomb_excess(MohrCoulomb const& law, Deviator const& s, double p) {
  auto const values = principal(s).values;
  double const slope = std::sin(law.friction_angle);
  return values[0] - values[2] + (values[0] + values[2] - 2.0 * p) * slope -
         2.0 * law.cohesion * std::cos(law.friction_angle);
}

TEST(Tensor, PrincipalValuesGiveTheMatrixBack) {
  std::mt19937 random(7);
  for (int k = 0; k < 200; ++k) {
    Symmetric<3> m = random_deviator(random, 3.0);
    if (k % 5 == 0) m = {2.0, 2.0, -4.0, 0.0, 0.0, 0.0};
    if (k % 5 == 1) m[4] = m[5] = 0.0;
    Principal const p = principal(m);
    EXPECT_GE(p.values[0], p.values[1]);
    EXPECT_GE(p.values[1], p.values[2]);
    Symmetric<3> const again = from_principal(p);
    for (std::size_t n = 0; n < 6; ++n) EXPECT_NEAR(again[n], m[n], 1e-13 * frobenius_norm<3>(m));
  }
}

TEST(Tensor, ARotationTurnsByItsAngle) {
  Matrix3 const r = rotation({0.0, 0.0, 0.75});
  EXPECT_NEAR(r[0][0], std::cos(0.75), 1e-15);
  EXPECT_NEAR(r[1][0], std::sin(0.75), 1e-15);
  Matrix3 const tiny = rotation({1e-9, 2e-9, 0.0});
  EXPECT_NEAR(tiny[2][1], 1e-9, 1e-24);
}

// Whoever only turns must see the stress turn along, however far in one step.
TEST(StressUpdate, IsExactForARigidRotation) {
  Deviator const s{3.0, -1.0, -2.0, 0.5, -0.25, 1.5};
  std::array<double, 3> const turn{0.4, -1.1, 2.3};
  Deviator const turned_once = elastic_stress(s, 1e9, {{}, turn});
  Deviator const exact = turned(s, rotation(turn));
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(turned_once[k], exact[k], 1e-14);
}

TEST(StressUpdate, KeepsTheTraceZero) {
  Deformation const d{{0.01, 0.02, -0.005, 0.003, 0.001, 0.0}, {0.1, 0.0, 0.2}};
  Deviator const s = elastic_stress({1.0, 1.0, -2.0, 0.0, 3.0, 0.0}, 100.0, d);
  EXPECT_NEAR(s[0] + s[1] + s[2], 0.0, 1e-14);
}

TEST(StressUpdate, PlanesAndLinesKeepTheStressAcross) {
  Deviator const plane = unpacked<2>({3.0, -1.0, 0.5});
  EXPECT_EQ(plane[2], -2.0);
  Deviator const line = unpacked<1>({4.0});
  EXPECT_EQ(line[1], -2.0);
  EXPECT_EQ(packed<2>(plane), (Symmetric<2>{3.0, -1.0, 0.5}));
}

TEST(Strength, RadialReturnGoesToTheConeAndKeepsTheDirection) {
  DruckerPrager const law{1e6, 0.25, 2e5};
  Deviator const s = law.limit({6e5, -2e5, -4e5, 1e5, 0.0, 0.0}, 1e5);
  EXPECT_NEAR(shear_norm(s), 2e5 + 0.75 * 1e5, 1e-6);
  EXPECT_NEAR(s[1] / s[0], -2.0 / 6.0, 1e-14);
}

TEST(Strength, MohrCoulombEndsOnItsSurfaceAndGetsThereAlongTheLargestDifference) {
  MohrCoulomb const law{1e6, 0.6, 2e4};
  double const p = 5e4;
  std::mt19937 random(11);
  int on_a_face = 0;
  for (int k = 0; k < 300; ++k) {
    Deviator const trial = random_deviator(random, 8e4);
    Deviator const s = law.limit(trial, p);
    double const size = shear_norm(trial);
    if (mohr_coulomb_excess(law, trial, p) <= 0.0) {
      EXPECT_EQ(s, trial);
      continue;
    }
    EXPECT_NEAR(mohr_coulomb_excess(law, s, p), 0.0, 1e-9 * size);
    EXPECT_NEAR(s[0] + s[1] + s[2], 0.0, 1e-9 * size);
    Symmetric<3> taken{};
    for (std::size_t n = 0; n < 6; ++n) taken[n] = trial[n] - s[n];
    EXPECT_GE(contraction(s, taken), -1e-9 * size * size) << "plastic work is never negative";
    // Away from corners the return runs along (1, 0, -1): flow without dilation.
    auto const before = principal(trial).values, after = principal(s).values;
    if (std::min(after[0] - after[1], after[1] - after[2]) > 1e-6 * size) {
      ++on_a_face;
      EXPECT_NEAR(after[1], before[1], 1e-9 * size);
      EXPECT_NEAR(before[0] - after[0], after[2] - before[2], 1e-9 * size);
    }
    // What yields keeps its principal directions: the matrices commute.
    Matrix3 const a = full(trial), b = full(s);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        double commutator = 0.0;
        for (std::size_t n = 0; n < 3; ++n) commutator += a[i][n] * b[n][j] - b[i][n] * a[n][j];
        EXPECT_NEAR(commutator, 0.0, 1e-9 * size * size);
      }
  }
  EXPECT_GT(on_a_face, 50);
}

TEST(Strength, MohrCoulombWithoutFrictionIsTresca) {
  MohrCoulomb const law{1e6, 0.0, 2e4};
  Deviator const s = law.limit({5e4, 0.0, -5e4, 0.0, 0.0, 0.0}, 0.0);
  EXPECT_NEAR(s[0], 2e4, 1e-9);
  EXPECT_NEAR(s[2], -2e4, 1e-9);
  EXPECT_NEAR(s[1], 0.0, 1e-9);
}

TEST(Strength, MohrCoulombBearsNothingBeyondItsApex) {
  MohrCoulomb const law{1e6, 0.5, 1e4};
  double const apex = law.cohesion / std::tan(law.friction_angle);
  EXPECT_EQ(shear_norm(law.limit({1e5, -1e5, 0.0, 0.0, 0.0, 0.0}, -1.001 * apex)), 0.0);
}

}  // namespace
}  // namespace moraine
