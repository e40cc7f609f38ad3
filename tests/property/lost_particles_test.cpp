// Particles that leave the domain: removed with the next rebuild, and harmless until then.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <string>
#include <vector>

#include "step/simulation_error.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

/// A random box without walls whose sides along x are open: it expands and loses particles all the
/// time.
Model leaking_box(int dimension, double end) {
  RandomBox box;
  box.dimension = dimension;
  box.side = std::array{0, 100, 24, 8}[static_cast<std::size_t>(dimension)];
  box.velocity = 0.3;
  Model model = random_box(box, end);
  model.periodic[0] = false;
  return model;
}

struct Leak {
  std::uint64_t count = 0;
  double mass = 0.0;
  double energy = 0.0;
  std::uint64_t rebuilds = 0;
  int steps_that_lost = 0;
  std::vector<double> state;
};

Leak after(int steps, int dimension, int threads) {
  int const before = omp_get_max_threads();
  omp_set_num_threads(threads);
  Simulation simulation(leaking_box(dimension, 10.0));
  Leak leak;
  for (int step = 0; step < steps; ++step) {
    auto const lost = simulation.lost().count;
    auto const rebuilds = simulation.search().rebuilds();
    simulation.advance();
    if (simulation.lost().count == lost) continue;
    ++leak.steps_that_lost;
    EXPECT_EQ(simulation.search().rebuilds(), rebuilds + 1) << "step " << step;
  }
  omp_set_num_threads(before);
  leak.count = simulation.lost().count;
  leak.mass = simulation.lost().mass;
  leak.energy = simulation.lost().energy;
  leak.rebuilds = simulation.search().rebuilds();
  leak.state = state_by_id(simulation.particles());
  return leak;
}

class LostOf : public testing::TestWithParam<int> {};

TEST_P(LostOf, AreRemovedWithRebuildsOnlyAndTheSameForAnyThreads) {
  Leak const one = after(60, GetParam(), 1);
  EXPECT_GT(one.count, 1U);
  EXPECT_GT(one.steps_that_lost, 1);
  for (int const threads : {2, 5}) {
    Leak const more = after(60, GetParam(), threads);
    EXPECT_EQ(more.count, one.count);
    EXPECT_EQ(more.mass, one.mass);
    EXPECT_EQ(more.energy, one.energy);
    EXPECT_EQ(more.rebuilds, one.rebuilds);
    EXPECT_TRUE(more.state == one.state);
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, LostOf, testing::Values(1, 2, 3));

// Leaving costs no rebuild of its own: a particle in free flight across the side leaves together
// with the lists that its motion wears out.
TEST(Lost, TriggerNoFurtherRebuild) {
  auto const rebuilds = [](double right_side) {
    RandomBox box;
    box.side = 2;
    Model model = random_box(box, 1.0);
    model.periodic = {};
    model.domain_min = {-1.0, -1.0, 0.0};
    model.domain_max = {right_side, 1.0, 0.0};
    model.time.fixed_step = 1e-4;
    ParticleStore& store = model.particles;
    for (double& v : store.component(Field::velocity, 1)) v = 0.0;
    for (std::size_t i = 0; i < store.size(); ++i) {
      store.component(Field::position, 0)[i] = -0.1 * static_cast<double>(store.id()[i]);
      store.component(Field::velocity, 0)[i] = store.id()[i] == 0 ? 10.0 : 0.0;
    }
    Simulation simulation(std::move(model));
    for (int step = 0; step < 200; ++step) simulation.advance();  // the first flies 0.2 m
    EXPECT_EQ(simulation.lost().count, right_side < 0.2 ? 1U : 0U);
    return simulation.search().rebuilds();
  };
  EXPECT_LE(rebuilds(0.1), rebuilds(1.0));
}

// What they take along: mass, and kinetic, internal and potential energy, once.
TEST(Lost, AreCountedWithMassAndEnergy) {
  RandomBox box;
  box.side = 2;
  Model model = random_box(box, 1.0);
  model.periodic = {};
  model.domain_min = {-1.0, -1.0, 0.0};
  model.domain_max = {1.0, 1.0, 0.0};
  model.gravity = {0.0, -9.81, 0.0};
  ParticleStore& store = model.particles;
  double const far[] = {3.0, 0.5};
  double const speed[] = {4.0, -2.0};
  for (int axis = 0; axis < 2; ++axis) {
    store.component(Field::position, axis)[2] = far[axis];
    store.component(Field::velocity, axis)[2] = speed[axis];
  }
  store.scalar(Field::specific_energy)[2] = 7.0;
  double const mass = store.scalar(Field::mass)[2];
  Simulation const simulation(std::move(model));
  EXPECT_EQ(simulation.particles().range(Kind::fluid).size(), 3U);
  EXPECT_EQ(simulation.lost().count, 1U);
  EXPECT_EQ(simulation.lost().mass, mass);
  // Four roundings at most.
  double const specific = 7.0 + 0.5 * (16.0 + 4.0) + 9.81 * 0.5;
  EXPECT_NEAR(simulation.lost().energy, mass * specific, 1e-15 * mass * specific * 4.0);
}

// Places that fixed point cannot hold wear the lists out, whatever their size.
TEST(Lost, MayLieAnywhere) {
  for (double const x : {3.0, -3.0, 1e4, -1e9, 1e30, -1e300}) {
    RandomBox box;
    box.side = 8;
    Model model = random_box(box, 1.0);
    model.periodic = {};
    Simulation const start(model);
    ParticleStore store = start.particles();
    Search search = start.search();
    ASSERT_TRUE(search.lists_hold(store));
    store.component(Field::position, 1)[5] = x;
    EXPECT_FALSE(search.lists_hold(store)) << x;
  }
}

TEST(Lost, AllOfThemEndTheRun) {
  RandomBox box;
  box.side = 2;
  Model model = random_box(box, 1.0);
  model.periodic = {};
  for (double& x : model.particles.component(Field::position, 0)) x += 1.0;
  try {
    Simulation const simulation(std::move(model));
    FAIL() << "runs without particles";
  } catch (SimulationError const& error) {
    EXPECT_NE(std::string(error.what()).find("all particles have left the domain"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace moraine
