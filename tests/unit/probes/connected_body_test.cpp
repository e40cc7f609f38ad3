// The heaviest group of neighbours, also across periodic sides.
#include "probes/connected_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "probes/selection.hpp"
#include "support/carved_ground.hpp"

namespace moraine {
namespace {

constexpr double spacing = 0.02;
constexpr double support = 2.0 * 1.2 * spacing;

/// 2D ground of 20 x 5 particles with 25 particles whose lowest row is `gap` above the highest row
/// of the ground.
ConnectedBody body_with_gap(double gap, bool all = true) {
  Case const c = ground_case(2, spacing, 0.2, 0.1, 0.0, spacing);
  Model model = build_model(c);
  // The lattice has put the row one spacing too high.
  for (double& y : model.particles.component(Field::position, 1))
    if (y > 0.0) y += gap - 2.0 * spacing;
  Simulation const simulation(std::move(model));
  ParticleStore const& store = simulation.particles();
  auto chosen = Selection{}.of(store);
  if (!all) std::fill(chosen.begin(), chosen.end(), std::uint8_t{0});
  return connected_body(store, simulation.search(), c.numerics.smoothing_length(), chosen);
}

TEST(ConnectedBody, EndsBeyondTheSupport) {
  ConnectedBody const near = body_with_gap(0.99 * support);
  EXPECT_EQ(near.particles, 125U);
  EXPECT_EQ(near.detached, 0U);
  ConnectedBody const far = body_with_gap(1.01 * support);
  EXPECT_EQ(far.particles, 100U);
  EXPECT_EQ(far.detached, 25U);
  EXPECT_NEAR(far.detached_share(), 0.2, 1e-12);
  EXPECT_EQ(std::accumulate(far.members.begin(), far.members.end(), 0), 100);
}

TEST(ConnectedBody, OfNothingIsEmpty) {
  ConnectedBody const none = body_with_gap(support, false);
  EXPECT_EQ(none.particles, 0U);
  EXPECT_EQ(none.detached_share(), 0.0);
}

// Two blocks at opposite sides of a periodic domain touch each other across the seam.
TEST(ConnectedBody, GoesOnAcrossPeriodicSides) {
  Case c = ground_case(2, spacing, 0.2, 0.1, 0.0, 0.1);
  c.regions = {{"left", "soil", Box{{-0.2, -0.1, 0.0}, {-0.1, 0.0, 0.0}}, {}},
               {"right", "soil", Box{{0.1, -0.1, 0.0}, {0.2, 0.0, 0.0}}, {}}};
  for (bool const periodic : {true, false}) {
    c.periodic[0] = periodic;
    Simulation const simulation(build_model(c));
    ParticleStore const& store = simulation.particles();
    ConnectedBody const body = connected_body(store, simulation.search(),
                                              c.numerics.smoothing_length(), Selection{}.of(store));
    EXPECT_EQ(body.particles, periodic ? 50U : 25U);
  }
}

}  // namespace
}  // namespace moraine
