// What leaves the domain is removed and booked: number, mass, energy.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/small_models.hpp"

namespace moraine {
namespace {

/// Two particles out of each other's reach under gravity; the second one flies out of the domain.
Model one_leaves() {
  RandomBox box;
  box.side = 2;
  box.scheme = SchemeName::liquid;
  box.displacement = 0.0;
  box.velocity = 0.0;
  Model model = random_box(box, 0.2);
  model.periodic = {};
  model.domain_min = {-5.0, -5.0, 0.0};
  model.domain_max = {5.0, 5.0, 0.0};
  model.gravity = {0.0, -9.81, 0.0};
  model.time.fixed_step = 0.0001;
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.size(); ++i) {
    store.component(Field::position, 0)[i] = static_cast<double>(i) - 2.0;
    store.component(Field::position, 1)[i] = 1.0;
    store.scalar(Field::density)[i] = 1000.0;
    store.scalar(Field::mass)[i] = 1.0 + static_cast<double>(i);
    store.scalar(Field::specific_energy)[i] = 10.0 * static_cast<double>(i);
  }
  store.component(Field::velocity, 0)[3] = 50.0;  // 4 m to go: gone after 0.08 s
  return model;
}

// Free flight keeps the energy of leapfrog to rounding: some hundred steps of 5000 J.
constexpr double rounding = 1e-9;  // J

TEST(LostParticles, AreCountedWithMassAndEnergy) {
  Model const model = one_leaves();
  Simulation simulation(model);
  ConservedSums const before = simulation.sums();
  while (simulation.running()) {
    simulation.advance();
    ConservedSums const now = simulation.sums();
    // Nothing but free flight: what the sums have lost is booked, at any time.
    EXPECT_NEAR(now.mass + simulation.lost().mass, before.mass, 1e-12);
    EXPECT_NEAR(now.total_energy() + simulation.lost().energy, before.total_energy(), rounding);
  }
  EXPECT_EQ(simulation.lost().count, 1u);
  EXPECT_DOUBLE_EQ(simulation.lost().mass, 4.0);
  // m (v^2 / 2 + e + g y), of the start: free flight keeps it.
  EXPECT_NEAR(simulation.lost().energy, 4.0 * (0.5 * 2500.0 + 30.0 + 9.81), rounding);
  auto const id = simulation.particles().id();
  EXPECT_EQ(simulation.particles().range(Kind::fluid).size(), 3u);
  EXPECT_EQ(std::count(id.begin(), id.end(), 3u), 0) << "the right one";
}

// The last particle flies out through x+; through y- where it starts below that side as well, and
// is farther beyond it.
TEST(LostParticles, AreBookedAtTheSideTheyWentThrough) {
  for (bool const below : {false, true}) {
    Model model = one_leaves();
    if (below) model.particles.component(Field::velocity, 1)[3] = -100.0;
    Simulation simulation(std::move(model));
    while (simulation.running()) simulation.advance();
    std::size_t const expected = below ? 2 : 1;
    for (std::size_t side = 0; side < 6; ++side)
      EXPECT_EQ(simulation.lost_through()[side].count, side == expected ? 1u : 0u) << side;
    EXPECT_EQ(simulation.lost_through()[expected].mass, simulation.lost().mass);
    EXPECT_EQ(simulation.lost_through()[expected].energy, simulation.lost().energy);
  }
}

TEST(LostParticles, NoneOnPeriodicAxes) {
  Model model = one_leaves();
  model.periodic[0] = true;
  model.time.end = 0.1;  // it comes back at the other side, and does not reach the others yet
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  EXPECT_EQ(simulation.lost().count, 0u);
  EXPECT_EQ(simulation.particles().range(Kind::fluid).size(), 4u);
}

}  // namespace
}  // namespace moraine
