#include "exact/slab_release.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "unit/exact/integral.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

RiemannSide tnt() { return {Jwl{}, 1630.0, 0.0, 4.29e6}; }

// The whole charge at e_0 and rho_0: 8.38 GPa and 4080 m/s.
TEST(SlabRelease, MeetsTheWallAfterOneTransit) {
  SlabRelease const slab(tnt(), std::nullopt, 0.1);
  Jwl const law;
  double const c = law.sound_speed(1630.0, 4.29e6);
  EXPECT_NEAR(c, 4080.0, 10.0);
  EXPECT_NEAR(slab.meeting_time(), 0.1 / c, 1e-12 * 0.1 / c);
  EXPECT_NEAR(slab.sample(0.0, slab.meeting_time()).pressure, 8.38e9, 0.01e9);
}

// Products that are left alone keep their mass and energy; the wall pushes with the first pressure.
TEST(SlabRelease, ConservesInVacuum) {
  double const thickness = 0.1;
  SlabRelease const slab(tnt(), std::nullopt, thickness);
  double const t = 0.8 * slab.meeting_time();
  double const head = thickness + slab.waves().left_wave().head * t;
  double const front = thickness + slab.waves().star_velocity() * t;
  auto const all = [&](auto const& density) {
    // Most of the distance holds nearly nothing: the pieces halve towards the head.
    double const d = front - head;
    return integral(
        [&](double x) { return density(slab.sample(x, t)); },
        {0.0, head, head + 0.01 * d, head + 0.1 * d, head + 0.3 * d, head + 0.6 * d, front});
  };
  double const mass = 1630.0 * thickness;
  EXPECT_NEAR(all([](FlowState const& s) { return s.density; }), mass, 1e-10 * mass);
  double const push = slab.sample(0.0, t).pressure * t;
  EXPECT_NEAR(all([](FlowState const& s) { return s.density * s.velocity; }), push, 1e-10 * push);
  EXPECT_NEAR(all([](FlowState const& s) {
                return s.density * (s.specific_energy + 0.5 * s.velocity * s.velocity);
              }),
              mass * 4.29e6, 1e-10 * mass * 4.29e6);
}

// In water: below the vacuum's speed, above the speed of a charge that water of the products' own
// impedance would give.
TEST(SlabRelease, PushesWater) {
  WaterPolynomial const water;
  RiemannSide const sea{water, 1000.0, 0.0, water.reference_energy};
  SlabRelease const slab(tnt(), sea, 0.1);
  double const t = 0.5 * slab.meeting_time();
  double const contact = 0.1 + slab.waves().star_velocity() * t;
  FlowState const inside = slab.sample(contact - 1e-6, t), outside = slab.sample(contact + 1e-6, t);
  EXPECT_NEAR(inside.pressure, outside.pressure, 1e-9 * inside.pressure);
  EXPECT_NEAR(inside.velocity, outside.velocity, 1e-9 * inside.velocity);
  EXPECT_LT(outside.density, 2000.0);
  EXPECT_EQ(slab.sample(10.0, t).pressure, water.pressure(1000.0, water.reference_energy));
}

TEST(SlabRelease, RefusesTimesAfterTheMeeting) {
  SlabRelease const slab(tnt(), std::nullopt, 0.1);
  EXPECT_EQ(
      message_of<std::invalid_argument>([&] { slab.sample(0.0, 1.01 * slab.meeting_time()); }),
      "slab release: the time is not before the wave meets the wall");
  EXPECT_EQ(message_of<std::invalid_argument>([] { SlabRelease(tnt(), std::nullopt, 0.0); }),
            "slab release: the thickness must be positive");
}

}  // namespace
}  // namespace moraine
