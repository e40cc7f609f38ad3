// Deposits, bubbles and highest surfaces of known arrangements.
#include "probes/body_probes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "probes/connected_body.hpp"
#include "support/carved_ground.hpp"

namespace moraine {
namespace {

constexpr double spacing = 0.02;

Simulation block(int dimension, Box const& box) {
  Case c = ground_case(dimension, spacing, 0.4, 0.16, 0.0, 0.1);
  c.regions = {{"block", "soil", box, {}}};
  c.domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  return Simulation(build_model(c));
}

// Ends of particles on the lattice are the faces of the box.
TEST(DepositProbe, ABoxEndsAtItsFaces) {
  Simulation const run = block(2, {{0.1, 0.0, 0.0}, {0.5, 0.12, 0.0}});
  std::vector<std::uint8_t> const members(run.particles().range(Kind::fluid).size(), 1);
  DepositFrame frame{{1, 1.0}, 0.0, {0.1, 0.0, 0.0}, Upwards{0, 1.0}};
  auto const right = probe_deposit(run.particles(), members, frame);
  EXPECT_NEAR(right.run_out, 0.4, 1e-6);
  EXPECT_NEAR(right.height, 0.12, 1e-6);
  EXPECT_NEAR(right.front_angle, 0.5 * std::numbers::pi, 1e-4);
  frame.along->sign = -1.0;
  EXPECT_NEAR(probe_deposit(run.particles(), members, frame).run_out, 0.0, 1e-6);
  frame.base = -0.5;
  EXPECT_NEAR(probe_deposit(run.particles(), members, frame).height, 0.62, 1e-6);
}

// The corner of the box is a corner particle's place and half its size further.
TEST(DepositProbe, RoundAboutCountsTheHorizontalDistance) {
  Simulation const run = block(3, {{-0.2, -0.1, 0.0}, {0.2, 0.1, 0.1}});
  std::vector<std::uint8_t> const members(run.particles().range(Kind::fluid).size(), 1);
  auto const round =
      probe_deposit(run.particles(), members, {{2, 1.0}, 0.0, {0.0, 0.0, 9.0}, std::nullopt});
  EXPECT_NEAR(round.run_out, std::hypot(0.19, 0.09) + 0.01, 1e-6);
  EXPECT_NEAR(round.height, 0.1, 1e-6);
}

// Of a heap with slopes of 1 in 2, half a spacing at both ends of the line: 1 in 2 up to spacing by
// half the height.
TEST(DepositProbe, AHeapHasTheSlopeOfItsFront) {
  Case c = ground_case(2, spacing, 0.4, 0.0, 0.2, 0.1);
  Simulation const run(carved(c, 0.2, [](double r) { return 0.15 - 0.5 * r; }));
  ParticleStore const& store = run.particles();
  auto const body =
      connected_body(store, run.search(), c.numerics.smoothing_length(), Selection{}.of(store));
  auto const heap = probe_deposit(store, body.members, {{1, 1.0}, 0.0, Vec3{}, Upwards{0, 1.0}});
  EXPECT_NEAR(heap.run_out, 0.3, spacing);
  EXPECT_NEAR(heap.height, 0.15, spacing);
  EXPECT_NEAR(std::tan(heap.front_angle), 0.5, spacing / 0.075);
}

TEST(DepositProbe, OfNothingIsNoNumber) {
  Simulation const run = block(2, {{0.1, 0.0, 0.0}, {0.2, 0.1, 0.0}});
  std::vector<std::uint8_t> const members(run.particles().range(Kind::fluid).size(), 0);
  EXPECT_TRUE(std::isnan(probe_deposit(run.particles(), members, {}).run_out));
}

TEST(BubbleProbe, ABoxHasItsVolumePlaceAndEnds) {
  Simulation const run = block(3, {{-0.1, 0.2, 0.0}, {0.1, 0.3, 0.06}});
  auto const bubble = probe_bubble(run.particles(), {}, 1);
  EXPECT_NEAR(bubble.volume, 0.2 * 0.1 * 0.06, 1e-9);
  EXPECT_NEAR(bubble.radius, std::cbrt(0.75 * 0.2 * 0.1 * 0.06 / std::numbers::pi), 1e-9);
  Vec3 const center{0.0, 0.25, 0.03}, low{-0.1, 0.2, 0.0}, high{0.1, 0.3, 0.06};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(bubble.center[axis], center[axis], 1e-6);
    EXPECT_NEAR(bubble.low[axis], low[axis], 1e-6);
    EXPECT_NEAR(bubble.high[axis], high[axis], 1e-6);
  }
  EXPECT_NEAR(probe_bubble(run.particles(), {}, 4).volume, 4.0 * bubble.volume, 1e-9);
}

TEST(BubbleProbe, InTheBoxOfAnotherThereIsNone) {
  Simulation const run = block(2, {{0.0, 0.0, 0.0}, {0.1, 0.1, 0.0}});
  auto const bubble =
      probe_bubble(run.particles(), {{}, PlaceBox{{0.5, 0.5, 0.0}, {0.6, 0.6, 0.0}}}, 1);
  EXPECT_EQ(bubble.volume, 0.0);
  EXPECT_TRUE(std::isnan(bubble.center[0]));
  auto const half =
      probe_bubble(run.particles(), {{}, PlaceBox{{-1.0, -1.0, 0.0}, {0.05, 1.0, 0.0}}}, 1);
  EXPECT_NEAR(half.volume, 0.1 * (half.high[0] - half.low[0]), 1e-9);
}

// A mound of half a sine on still water: its top is known to half a spacing, the level far from it
// to a tenth.
TEST(HighestSurface, IsThatOfTheMound) {
  for (int const dimension : {2, 3}) {
    Case const c = ground_case(dimension, spacing, 0.4, 0.16, 0.08, 0.1);
    auto const mound = [](double r) {
      return r < 0.2 ? 0.06 * std::cos(0.5 * std::numbers::pi * r / 0.2) : 0.0;
    };
    Simulation const run(carved(c, 0.12, mound));
    ParticleStore const& store = run.particles();
    double const h = c.numerics.smoothing_length();
    auto const body = connected_body(store, run.search(), h, Selection{}.of(store));
    BodyView const view{store, run.search(), c.numerics.kernel,
                        h,     body.members, {static_cast<std::size_t>(dimension - 1), 1.0}};
    EXPECT_NEAR(probe_highest(view, {c.domain.min, c.domain.max}), 0.06, 0.5 * spacing);
    Vec3 corner = c.domain.min;
    corner[0] = 0.3;
    EXPECT_NEAR(probe_highest(view, {corner, c.domain.max}), 0.0, 0.1 * spacing);
    corner[0] = 0.399;
    corner[static_cast<std::size_t>(dimension - 1)] = 0.05;
    EXPECT_TRUE(std::isnan(probe_highest(view, {corner, c.domain.max})));
  }
}

}  // namespace
}  // namespace moraine
