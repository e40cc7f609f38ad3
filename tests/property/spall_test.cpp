// Material that parts in tension.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

/// A bar of one metre whose halves move apart with 20 m/s each.
Case torn_bar(TensionEnd tension) {
  Case c;
  c.dimension = 1;
  c.domain = {{-1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  c.numerics.spacing = 1e-2;
  c.numerics.precision = Precision::full;
  c.time.end = 4e-4;
  UsUp rock;
  rock.reference_density = 2500.0;
  rock.reference_sound_speed = 3000.0;
  rock.least_pressure = -5e6;
  MaterialSpec material{.name = "rock", .eos = rock};
  material.strength = {.kind = StrengthKind::elastic, .shear_modulus = 5e9};
  material.tension = tension;
  c.materials = {material};
  RegionSpec left{"left", "rock", Box{{0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}}, {}};
  RegionSpec right{"right", "rock", Box{{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {}};
  left.initial.velocity = {-20.0, 0.0, 0.0};
  right.initial.velocity = {20.0, 0.0, 0.0};
  c.regions = {left, right};
  return c;
}

/// Momentum of the right half [kg m/s], and how many particles have parted.
struct Torn {
  double momentum = 0.0;
  int parted = 0;
  double least_pressure = 0.0, most_shear = 0.0;  // of what has parted
};

Torn tear(TensionEnd tension) {
  Simulation simulation(build_model(torn_bar(tension)));
  while (simulation.running()) simulation.advance();
  ParticleStore const& store = simulation.particles();
  Torn torn;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    if (store.component(Field::position, 0)[i] > 0.5)
      torn.momentum += store.scalar(Field::mass)[i] * store.component(Field::velocity, 0)[i];
    if (!store.has(Field::spalled) || store.scalar(Field::spalled)[i] == 0.0) continue;
    ++torn.parted;
    double const p = store.scalar(Field::pressure)[i];
    torn.least_pressure = std::min(torn.least_pressure, p);
    if (p <= 0.0)
      torn.most_shear =
          std::max(torn.most_shear, std::fabs(store.component(Field::deviatoric_stress, 0)[i]));
  }
  return torn;
}

// What has parted pulls no more: the halves keep the momentum that the floor goes on taking.
TEST(Spall, WhatHasPartedPullsNoMore) {
  Torn const floor = tear(TensionEnd::floor);
  Torn const spall = tear(TensionEnd::spall);
  EXPECT_EQ(floor.parted, 0);
  EXPECT_GT(spall.parted, 1);
  double const whole = 0.5 * 2500.0 * 20.0;
  EXPECT_GT(spall.momentum, floor.momentum + 0.02 * whole);
  EXPECT_GE(spall.least_pressure, 0.0) << "of what has parted";
  EXPECT_EQ(spall.most_shear, 0.0) << "of what has parted and is not pressed";
}

}  // namespace
}  // namespace moraine
