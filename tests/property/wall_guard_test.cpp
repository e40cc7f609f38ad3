// Particles inside walls: who is in deep enough is found, who only passes by is not.
#include "step/wall_guard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation.hpp"
#include "step/simulation_error.hpp"
#include "walls/clearance.hpp"

namespace moraine {
namespace {

constexpr double spacing = 0.1;  // m
constexpr int layers = 3;        // of dummies at a smoothing factor of 1.2

/// One particle of water in a tank of 2 m x 1 m without a lid; a second one far above it.
Model one_particle(Vec3 const& place, Vec3 const& velocity = {}) {
  Case c = parse_case(R"(
space = { dimension = 2, domain = { min = [-4.0, -4.0], max = [6.0, 6.0] } }
resolution.spacing = 0.1
time.end = 10.0
material.water = { eos = "tait", reference_sound_speed = 10.0 }
[[region]]
name = "drop"
material = "water"
box = { min = [0.9, 0.4], max = [1.0, 0.5] }
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [2.0, 1.0] }
open = ["y+"]
)",
                      "case.toml");
  Model model = build_model(c);
  EXPECT_EQ(model.particles.range(Kind::fluid).size(), 1U);
  for (int axis = 0; axis < 2; ++axis) {
    model.particles.component(Field::position, axis)[0] = place[static_cast<std::size_t>(axis)];
    model.particles.component(Field::velocity, axis)[0] = velocity[static_cast<std::size_t>(axis)];
  }
  return model;
}

bool found_at(Vec3 const& place) {
  Simulation const simulation(one_particle(place));
  try {
    simulation.check();
  } catch (SimulationError const& error) {
    EXPECT_EQ(error.flags().size(), 1U);
    EXPECT_EQ(error.flags().at(0).guard, flag_of(Guard::walls));
    EXPECT_NE(std::string(error.what()).find("it is inside a wall"), std::string::npos)
        << error.what();
    return true;
  }
  return false;
}

// Between the dummies the bound from below is at most 0.15 spacings off in two dimensions:
// 1.5 - sqrt(1 - 0.5^2) = 0.63 spacings for the second layer, 2.5 - sqrt(...) for the third.
TEST(WallGuard, FindsWhoIsBehindAFace) {
  for (double const along : {0.5, 0.537, 0.55, 0.6})
    for (double depth = 0.64; depth < 2.3; depth += 0.05) {
      EXPECT_TRUE(found_at({-depth * spacing, along, 0.0})) << depth << " at " << along;
      EXPECT_TRUE(found_at({along, -depth * spacing, 0.0})) << depth << " at " << along;
      EXPECT_TRUE(found_at({-depth * spacing, -depth * spacing, 0.0})) << "behind the edge";
    }
}

TEST(WallGuard, LetsWhoIsNearAFaceOrPressedIntoItPass) {
  for (double const along : {0.5, 0.537, 0.55})
    for (double depth = -1.0; depth < 0.5; depth += 0.05) {
      EXPECT_FALSE(found_at({-depth * spacing, along, 0.0})) << depth;
      EXPECT_FALSE(found_at({along, -depth * spacing, 0.0})) << depth;
    }
}

// Ejecta: over the rim, however low, and outside, behind the wall.
TEST(WallGuard, LetsWhoPassesOverTheRimOrBehindTheWallPass) {
  for (double x = -5.0; x < 0.5; x += 0.1)
    for (double const above : {0.01, 0.2, 0.7, 2.0})
      EXPECT_FALSE(found_at({x * spacing, 1.0 + above * spacing, 0.0})) << x << ", " << above;
  for (double const behind : {3.01, 3.2, 4.0})
    for (double const y : {0.1, 0.53, 0.98})
      EXPECT_FALSE(found_at({-behind * spacing, y, 0.0})) << behind;
}

TEST(WallGuard, NamesTheDepth) {
  Simulation const simulation(one_particle({-1.5 * spacing, 0.55, 0.0}));
  WallGuardView const view{simulation.particles(), simulation.search(), simulation.model().walls};
  EXPECT_NEAR(deepest_in_walls(view, 0.5 * spacing), 1.5 * spacing, 1e-7)
      << "a place of a wall particle";
  auto const suspects = deeper_in_walls(view, 0.5 * spacing);
  ASSERT_EQ(suspects.size(), 1U);
  EXPECT_NEAR(suspects[0].badness, 1.5 * spacing, 1e-7);
}

/// Shot at the wall in fixed steps of a part of the smoothing length, without viscosity: too fast
/// for the contact to hold it back.
Model bullet(double speed, double part, double from) {
  Model model = one_particle({from, 0.532, 0.0}, {-speed, 0.0, 0.0});
  model.numerics.viscosity_alpha = 0.0;
  model.numerics.viscosity_beta = 0.0;
  model.time.fixed_step = part * model.numerics.smoothing_length() / speed;
  for (GuardInfo const& guard : guard_table)
    if (guard.optional && guard.guard != Guard::walls)
      model.guards.off.push_back(std::string(guard.name));
  return model;
}

// Caught inside, whatever the step and the place that it starts from; with the guard off it passes.
TEST(WallGuard, CatchesWhoeverIsShotThroughAWall) {
  for (double const part : {0.2, 0.5, 0.95})
    for (double const from : {0.3, 0.33, 0.37, 0.51}) {
      Model unguarded = bullet(1000.0, part, from);
      unguarded.guards.off.push_back("walls");
      Simulation through(std::move(unguarded));
      auto const x = [](Simulation const& run) {
        return run.particles().component(Field::position, 0)[0];
      };
      for (int step = 0; step < 100 && x(through) > -4.0 * spacing; ++step) through.advance();
      ASSERT_LT(x(through), -4.0 * spacing);
      Simulation simulation(bullet(1000.0, part, from));
      std::optional<SimulationError> caught;
      try {
        while (x(simulation) > -4.0 * spacing) simulation.advance();
      } catch (SimulationError const& error) {
        caught = error;
      }
      ASSERT_TRUE(caught.has_value()) << part << " from " << from;
      ASSERT_EQ(caught->flags().size(), 1U) << caught->what();
      EXPECT_EQ(caught->flags()[0].guard, flag_of(Guard::walls)) << caught->what();
    }
}

TEST(WallGuard, ForgetsAWallThatIsGone) {
  Model model = one_particle({-1.5 * spacing, 0.55, 0.0});
  Stage release{"release", 0.0, {}, {}, {}};
  auto const id = model.particles.id();
  for (std::size_t i = 1; i < id.size(); ++i) release.removed_walls.push_back(id[i]);
  model.stages = {release};
  Simulation const simulation(std::move(model));
  EXPECT_NO_THROW(simulation.check());
}

/// Whether a place is in what dummies stand for, told by the sides alone.
bool is_solid(BoxWall const& wall, double thickness, Vec3 const& x) {
  bool inside = true;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(wall.dimension); ++axis)
    for (std::size_t end = 0; end < 2; ++end) {
      double const beyond = end == 0 ? wall.min[axis] - x[axis] : x[axis] - wall.max[axis];
      if (beyond > 0.0) inside = false;
      bool const solid_there = wall.solid == SolidSide::outside && !wall.open[axis][end];
      if (beyond > (solid_there ? thickness : 0.0)) return false;
    }
  return inside == (wall.solid == SolidSide::inside);
}

TEST(Clearance, IsTheRadiusOfABallOfSolid) {
  for (int const dimension : {1, 2, 3})
    for (SolidSide const solid : {SolidSide::outside, SolidSide::inside}) {
      BoxWall wall;
      wall.dimension = dimension;
      wall.max = {1.0, 0.8, 0.6};
      wall.solid = solid;
      if (solid == SolidSide::outside && dimension > 1)
        wall.open[static_cast<std::size_t>(dimension - 1)][1] = true;
      double largest = 0.0;
      for (Dummy const& dummy : make_dummy_layer(wall, spacing, layers, 0)) {
        double const radius = clearance(wall, layers * spacing, dummy);
        largest = std::max(largest, radius);
        EXPECT_LE(radius, dummy.depth * std::sqrt(dimension) * (1.0 + 1e-12))
            << "the depth, up to sqrt(d) of it behind corners";
        for (int direction = 0; direction < 64; ++direction) {
          Vec3 x = dummy.position;
          double const turn = 0.7 * direction, rise = std::cos(1.3 * direction);
          Vec3 const way{dimension == 1 ? 1.0 - 2.0 * (direction % 2) : std::cos(turn),
                         std::sin(turn), rise};
          double size = 0.0;
          for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
            size += way[k] * way[k];
          for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
            x[k] += 0.999 * radius * way[k] / std::sqrt(size);
          EXPECT_TRUE(is_solid(wall, layers * spacing, x)) << dimension << "D";
        }
      }
      EXPECT_GT(largest, 1.4 * spacing) << "in the middle of the layers";
    }
}

}  // namespace
}  // namespace moraine
