// Grids of places, and fields on them.
#include "probes/grid_probe.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "support/carved_ground.hpp"

namespace moraine {
namespace {

TEST(PlaceGrid, EndsAtBothCorners) {
  PlaceGrid const grid = grid_between({0.0, 1.0, -1.0}, {0.3, 1.0, 0.0}, 0.1);
  EXPECT_EQ(grid.points, (std::array<std::size_t, 3>{4, 1, 11}));
  EXPECT_EQ(grid.place(0), (Vec3{0.0, 1.0, -1.0}));
  Vec3 const last = grid.place(grid.size() - 1);
  EXPECT_NEAR(last[0], 0.3, 1e-15);
  EXPECT_NEAR(last[2], 0.0, 1e-15);
  EXPECT_EQ(grid_between({0.0, 0.0, 0.0}, {0.25, 0.05, 0.0}, 0.1).points,
            (std::array<std::size_t, 3>{4, 2, 1}));
}

// Points of a grid show what a point gauge there does, and nothing where no particle is near.
TEST(GridProbe, IsAPointProbeAtEachPlace) {
  Case const c = ground_case(3, 0.02, 0.1, 0.1, 0.0, 0.3);
  Simulation const run(build_model(c));
  double const h = c.numerics.smoothing_length();
  PlaceGrid const grid = grid_between({-0.1, 0.01, -0.1}, {0.1, 0.01, 0.1}, 0.05);
  auto const states = probe_grid(run.particles(), run.search(), c.numerics.kernel, h, grid);
  ASSERT_EQ(states.size(), 25U);
  for (std::size_t k = 0; k < states.size(); ++k) {
    PointState const alone =
        probe_point(run.particles(), run.search(), c.numerics.kernel, h, grid.place(k));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(states[k].density),
              std::bit_cast<std::uint64_t>(alone.density));
    EXPECT_EQ(std::isnan(states[k].density), grid.place(k)[2] > 0.04) << k;
  }
}

}  // namespace
}  // namespace moraine
