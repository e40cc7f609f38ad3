// Porous compaction: branches, memory, and what a cycle costs.
#include "matter/eos/p_alpha.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace moraine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Loose sand with a long tail, Herrmann's curve, and weak rock that is elastic at first.
std::vector<PAlpha> laws() {
  return {PAlpha{.full_compaction_pressure = 1.77e9, .crush_exponent = 1.0, .half_pressure = 44e6},
          PAlpha{},
          PAlpha{.reference_density = 2100.0,
                 .reference_sound_speed = 1500.0,
                 .elastic_limit = 5e6,
                 .full_compaction_pressure = 300e6,
                 .least_pressure = -1e6}};
}

// alpha = 1 + (alpha_e - 1) (1 - 30/75)^2 by hand, with alpha_e = 2650/1674.
TEST(CrushCurve, IsHerrmannsWithoutATail) {
  CrushCurve const curve = PAlpha{}.crush_curve();
  double const alpha_e = 2650.0 / 1674.0;
  EXPECT_DOUBLE_EQ(curve.distension, alpha_e);
  EXPECT_NEAR(curve.distension_at(30e6), 1.0 + (alpha_e - 1.0) * 0.36, 1e-15);
  EXPECT_EQ(curve.distension_at(-1.0), curve.distension);
  EXPECT_EQ(curve.distension_at(75e6), 1.0);
  EXPECT_EQ(curve.distension_at(1e12), 1.0);
}

TEST(CrushCurve, LosesHalfOfItsPoresAtTheHalfPressure) {
  CrushCurve const curve{1.6, 1e6, 100e9, 1.0, 40e6};
  EXPECT_NEAR(curve.distension_at(41e6), 1.0 + 0.6 * 0.5, 0.6 * 40e6 / 100e9);
}

TEST(CrushCurve, ItsInverseAndSlopeBelongToIt) {
  for (PAlpha const& law : laws()) {
    CrushCurve const curve = law.crush_curve();
    double const span = curve.full_compaction_pressure - curve.elastic_limit;
    for (double const part : {0.001, 0.1, 0.5, 0.9}) {
      double const p = curve.elastic_limit + part * span;
      EXPECT_NEAR(curve.pressure_at(curve.distension_at(p)), p, 1e-10 * span);
      double const step = 1e-6 * span;
      double const slope =
          (curve.distension_at(p + step) - curve.distension_at(p - step)) / (2 * step);
      EXPECT_NEAR(curve.at(p).slope, slope, 1e-6 * std::fabs(slope));
    }
    EXPECT_EQ(curve.pressure_at(2.0 * curve.distension), curve.elastic_limit);
    EXPECT_EQ(curve.pressure_at(1.0), curve.full_compaction_pressure);
  }
}

TEST(PAlpha, UndisturbedStateHasTheSoundSpeedOfTheSoil) {
  for (PAlpha const& law : laws()) {
    EXPECT_NEAR(law.pressure(law.reference_density, 0.0), 0.0, 1e-5);
    EXPECT_NEAR(law.sound_speed(law.reference_density, 0.0), law.reference_sound_speed,
                1e-9 * law.reference_sound_speed);
  }
}

// p = p_solid(alpha rho, e) / alpha on first loading, to the rounding of the solid's stiffness.
TEST(PAlpha, SolvesItsEquation) {
  for (PAlpha const& law : laws())
    for (double const ratio : {1.0001, 1.01, 1.1, 1.3, 1.5, 1.7})
      for (double const e : {0.0, 2e3, 1e5}) {
        double const rho = ratio * law.reference_density;
        CompactionResponse const found = law.virgin(rho, e);
        double const p = found.pressure;
        if (p <= law.elastic_limit) continue;
        double const alpha = law.crush_curve().distension_at(p);
        EXPECT_NEAR(found.distension, alpha, 1e-12);
        EXPECT_NEAR(law.solid().pressure(alpha * rho, e) / alpha, p,
                    1e-12 * p + 1e-14 * law.stiffness());
      }
}

// c^2 = dp/drho + (p / rho^2) dp/de by central differences, on every branch: 1e-6 of rounding in p
// over steps of 1e-6. States within a step of a corner of the law have no one slope.
TEST(PAlpha, SoundSpeedIsTheSlopeOfTheBranch) {
  for (PAlpha const& law : laws())
    for (double const least : {infinity, 1.2, 1.1, 1.01, 1.0})
      for (double const ratio : {0.97, 1.0001, 1.001, 1.01, 1.05, 1.1, 1.2, 1.4, 1.6, 2.0})
        for (double const e : {-1e3, 0.0, 1e4, 1e6}) {
          double const rho = ratio * law.reference_density;
          auto const p = [&](double density, double energy) {
            return law.respond(density, energy, least).pressure;
          };
          CompactionResponse const at = law.respond(rho, e, least);
          if (at.pressure == law.least_pressure) continue;
          double const d_rho = 1e-6 * rho;
          double const d_e = 1e-6 * std::fabs(e) + 0.1;
          double const p_rho = (p(rho + d_rho, e) - p(rho - d_rho, e)) / (2 * d_rho);
          double const p_e = (p(rho, e + d_e) - p(rho, e - d_e)) / (2 * d_e);
          double const expected = p_rho + at.pressure / (rho * rho) * p_e;
          EXPECT_NEAR(at.sound_speed_squared, expected, 1e-5 * expected)
              << "rho " << rho << " e " << e << " least " << least;
          // What unloads from here, by a difference downwards.
          double const back = law.respond(rho - d_rho, e, at.distension).pressure;
          double const unloading = (at.pressure - back) / d_rho + at.pressure / (rho * rho) * p_e;
          if (back > law.least_pressure) {
            EXPECT_NEAR(at.unloading_speed_squared, unloading, 0.02 * unloading)
                << "rho " << rho << " e " << e << " least " << least;
          }
          EXPECT_GE(at.unloading_speed_squared, (1.0 - 1e-6) * at.sound_speed_squared);
        }
}

TEST(PAlpha, PressureIsContinuousWhereBranchesMeet) {
  for (PAlpha const& law : laws())
    for (double const e : {0.0, 1e4})
      for (double const p : {law.elastic_limit + 1.0, 0.3 * law.full_compaction_pressure,
                             law.full_compaction_pressure}) {
        double const rho = law.density_at_pressure(p, e);
        double const least = law.virgin(rho, e).distension;
        for (double const memory : {infinity, least}) {
          double const below = law.respond(rho * (1 - 1e-12), e, memory).pressure;
          double const above = law.respond(rho * (1 + 1e-12), e, memory).pressure;
          EXPECT_NEAR(below, p, 1e-9 * law.stiffness()) << p;
          EXPECT_NEAR(above, p, 1e-9 * law.stiffness()) << p;
        }
      }
}

TEST(PAlpha, RemembersTheLeastDistensionAndNeverMore) {
  std::mt19937 random(7);
  for (PAlpha const& law : laws()) {
    std::uniform_real_distribution<double> density(0.9 * law.reference_density,
                                                   1.05 * law.solid_density);
    double least = law.virgin_distension();
    for (int k = 0; k < 200; ++k) {
      double const limit = 0.5 * (density(random) + law.reference_density);
      CompactionResponse const at = law.respond(limit, 1e3, least);
      ASSERT_LE(at.distension, least);
      ASSERT_GE(at.distension, 1.0);
      ASSERT_GE(at.sound_speed_squared, 0.0);
      ASSERT_GE(at.pressure, law.least_pressure);
      // To ask again changes nothing, but that loading has stopped.
      CompactionResponse const again = law.respond(limit, 1e3, at.distension);
      ASSERT_EQ(again.distension, at.distension);
      ASSERT_NEAR(again.pressure, at.pressure, 1e-12 * at.pressure + 1e-3);
      least = at.distension;
    }
  }
}

TEST(PAlpha, UnloadsStiffAndReloadsToTheSamePoint) {
  for (PAlpha const& law : laws()) {
    double const p = law.elastic_limit + 0.2 * law.full_compaction_pressure;
    double const rho = law.density_at_pressure(p, 0.0);
    double const least = law.virgin(rho, 0.0).distension;
    double const inside = 0.999 * rho;
    CompactionResponse const unloaded = law.respond(inside, 0.0, least);
    EXPECT_LT(unloaded.pressure, law.pressure(inside, 0.0)) << "off the crush curve";
    EXPECT_EQ(unloaded.distension, least);
    EXPECT_GT(unloaded.sound_speed_squared, law.sound_speed_squared(rho * 1.0001, 0.0));
    EXPECT_NEAR(law.respond(rho, 0.0, least).pressure, p, 1e-12 * p + 1e-3);
    EXPECT_NEAR(law.respond(1.01 * rho, 0.0, least).pressure, law.pressure(1.01 * rho, 0.0),
                1e-12 * p + 1e-3)
        << "beyond, it is loaded for the first time again";
  }
}

// Compacted to nothing but solid, it is the solid.
TEST(PAlpha, BecomesItsSolid) {
  for (PAlpha const& law : laws()) {
    UsUp solid = law.solid();
    solid.least_pressure = law.least_pressure;
    for (double const rho : {2500.0, 2650.0, 2700.0, 3500.0})
      for (double const e : {0.0, 1e5}) {
        CompactionResponse const at = law.respond(rho, e, 1.0);
        EXPECT_EQ(at.pressure, solid.pressure(rho, e));
        EXPECT_EQ(at.sound_speed_squared, solid.sound_speed_squared(rho, e));
        EXPECT_EQ(at.distension, 1.0);
      }
    EXPECT_LT(law.sound_speed(1.01 * law.limiting_density(), 0.0), 0.0);
  }
}

TEST(PAlpha, FloorFreezesPressureAndSoundSpeedAndOpensNoPore) {
  for (PAlpha const& law : laws())
    for (double const least : {infinity, 1.15, 1.0}) {
      CompactionResponse const first = law.respond(1000.0, 0.0, least);
      CompactionResponse const second = law.respond(10.0, 0.0, least);
      EXPECT_EQ(first.pressure, law.least_pressure);
      EXPECT_EQ(second.pressure, law.least_pressure);
      EXPECT_GT(first.sound_speed_squared, 0.0);
      EXPECT_EQ(first.sound_speed_squared, second.sound_speed_squared);
      EXPECT_LE(second.distension, least);
    }
}

TEST(PAlpha, InversesAreOfMaterialThatIsLoadedForTheFirstTime) {
  for (PAlpha const& law : laws())
    for (double const e : {0.0, 1e4})
      for (double const p : {0.0, 1e5, 4.9e6, 5.1e6, 3e7, 2.9e8, 1e9, 3e9}) {
        double const rho = law.density_at_pressure(p, e);
        EXPECT_NEAR(law.pressure(rho, e), p, 1e-12 * p + 1e-5);
        EXPECT_NEAR(law.energy_at_pressure(rho, p), e, 1e-9 * e + 1e-3);
      }
  EXPECT_TRUE(std::isnan(PAlpha{}.density_at_pressure(-1.0, 0.0)));
  EXPECT_TRUE(std::isnan(PAlpha{}.energy_at_pressure(1700.0, -1.0)));
}

/// Work of a slow change of density without heat, de = p/rho^2 drho, by the midpoint rule; the
/// memory follows the states that are passed.
struct Sample {
  PAlpha law;
  double rho, e = 0.0, least;
  double pressure = 0.0;

  explicit Sample(PAlpha const& of)
      : law(of), rho(of.reference_density), least(of.virgin_distension()) {}

  void move_to(double density, int steps) {
    double const step = (density - rho) / steps;
    for (int k = 0; k < steps; ++k) {
      double const middle = rho + 0.5 * step;
      double const half = law.respond(rho, e, least).pressure * 0.5 * step / (rho * rho);
      CompactionResponse const at = law.respond(middle, e + half, least);
      e += at.pressure / (middle * middle) * step;
      rho += step;
      CompactionResponse const after = law.respond(rho, e, least);
      least = after.distension;
      pressure = after.pressure;
    }
  }
};

// Loaded and unloaded to the density in which the pressure is zero: what is left is heat. Between
// p_e and p_s the work of crushing is at least what the crush curve says less what comes back.
TEST(PAlpha, CyclesLoseEnergyAndNeverGainIt) {
  for (PAlpha const& law : laws())
    for (double const part : {0.05, 0.3, 0.8}) {
      Sample sample(law);
      double const p = law.elastic_limit + part * law.full_compaction_pressure;
      double const top = law.density_at_pressure(p, 0.0);
      sample.move_to(top, 4000);
      double const loaded = sample.e;
      EXPECT_GT(loaded, 0.0);
      for (double rho = sample.rho; sample.pressure > 0.0 && rho > law.reference_density;)
        sample.move_to(rho -= 1e-5 * top, 1);
      EXPECT_GT(sample.e, 0.3 * loaded) << "most of the work is gone";
      EXPECT_LT(sample.e, loaded);
      EXPECT_GT(sample.rho, law.reference_density) << "pores stay crushed";
    }
}

// The elastic line alone is reversible: the state comes back, energy and all.
TEST(PAlpha, ReloadingCostsNothing) {
  for (PAlpha const& law : laws()) {
    Sample sample(law);
    double const top = law.density_at_pressure(0.3 * law.full_compaction_pressure, 0.0);
    sample.move_to(top, 4000);
    double const before = sample.e;
    double const least = sample.least;
    double const slack = 0.3 * sample.pressure / law.stiffness() * top;
    sample.move_to(top - slack, 2000);
    sample.move_to(top, 2000);
    EXPECT_NEAR(sample.e, before, 1e-6 * before);
    EXPECT_NEAR(sample.least, least, 1e-9);
  }
}

// Random closed cycles of density: energy at the same density and memory never falls.
TEST(PAlpha, NoClosedCycleCreatesEnergy) {
  std::mt19937 random(11);
  for (PAlpha const& law : laws()) {
    double const top = law.density_at_pressure(0.5 * law.full_compaction_pressure, 0.0);
    std::uniform_real_distribution<double> density(law.reference_density, top);
    Sample sample(law);
    for (int k = 0; k < 20; ++k) {
      double const home = sample.rho;
      double const before = sample.e;
      sample.move_to(density(random), 1000);
      sample.move_to(density(random), 1000);
      sample.move_to(home, 1000);
      ASSERT_GE(sample.e, before - 1e-6 * (std::fabs(before) + 1.0)) << "cycle " << k;
    }
  }
}

TEST(PAlpha, KnowsWhenUnloadingWouldCreateEnergy) {
  for (PAlpha const& law : laws()) EXPECT_TRUE(law.unloads_steeply());
  PAlpha soft{};
  soft.full_compaction_pressure = 500e6;  // a crush curve that begins at 600 m/s
  EXPECT_FALSE(soft.unloads_steeply());
  EXPECT_GT(soft.crush_speed(), soft.reference_sound_speed);
  soft.reference_sound_speed = 1.01 * soft.crush_speed();
  EXPECT_TRUE(soft.unloads_steeply());
}

TEST(PAlpha, KnowsHowMuchTensionItsPoresBear) {
  PAlpha const sand{};
  double const line = (std::pow(3680.0 / 265.0, 2) - 1.0) / sand.stiffness();
  EXPECT_NEAR(sand.largest_tension(), -1674.0 / 2650.0 / line, 1.0);
}

}  // namespace
}  // namespace moraine
