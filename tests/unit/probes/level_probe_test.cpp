// The height of still water at every offset of its lattice, in all dimensions.
#include "probes/level_probe.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double spacing = 0.02;  // m

struct Setting {
  int dimension;
  KernelName kernel;
  double factor;
};

/// A pool whose surface lies at `level`, without gravity.
Model pool(Setting const& setting, double level) {
  Case c;
  c.dimension = setting.dimension;
  auto const up = static_cast<std::size_t>(setting.dimension - 1);
  c.numerics.spacing = spacing;
  c.numerics.kernel = setting.kernel;
  c.numerics.smoothing_factor = setting.factor;
  Box water{{-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}};
  water.min[up] = level - 0.24;
  water.max[up] = level;
  c.domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  c.time.end = 1.0;
  c.materials = {{"water", Tait{}}};
  c.regions = {{"water", "water", water, {}}};
  return build_model(c);
}

/// Largest error of the level over offsets of line and lattice [spacings].
double largest_error(Setting const& setting) {
  double worst = 0.0;
  for (int offset = 0; offset < 8; ++offset) {
    Simulation const simulation(pool(setting, 0.125 * offset * spacing));
    double top = -1.0;
    auto const up = setting.dimension - 1;
    for (double const x : simulation.particles().component(Field::position, up))
      top = std::max(top, x);
    for (int across = 0; across < (setting.dimension == 1 ? 1 : 5); ++across) {
      Line line;
      for (int axis = 0; axis < up; ++axis)
        line.from[static_cast<std::size_t>(axis)] = line.to[static_cast<std::size_t>(axis)] =
            0.1 * across * spacing * (axis + 1);
      line.from[static_cast<std::size_t>(up)] = -0.1;
      line.to[static_cast<std::size_t>(up)] = 0.113;
      Model const& model = simulation.model();
      double const level =
          probe_level(simulation.particles(), simulation.search(), model.numerics.kernel,
                      model.numerics.smoothing_length(), line);
      worst = std::max(worst, std::fabs(level - (top + 0.5 * spacing)) / spacing);
    }
  }
  return worst;
}

class Level : public testing::TestWithParam<Setting> {};

// By definition the surface is half a spacing above the last row.
TEST_P(Level, OfStillWaterIsKnownToATenthOfASpacing) { EXPECT_LE(largest_error(GetParam()), 0.1); }

INSTANTIATE_TEST_SUITE_P(Settings, Level,
                         testing::Values(Setting{1, KernelName::wendland_c2, 1.5},
                                         Setting{2, KernelName::wendland_c2, 1.2},
                                         Setting{2, KernelName::wendland_c2, 1.5},
                                         Setting{2, KernelName::cubic_spline, 1.2},
                                         Setting{3, KernelName::wendland_c2, 1.2}));

double level_of(Simulation const& simulation, Line const& line) {
  Model const& model = simulation.model();
  return probe_level(simulation.particles(), simulation.search(), model.numerics.kernel,
                     model.numerics.smoothing_length(), line);
}

TEST(LevelProbe, OutsideOfTheFluidThereIsNone) {
  Simulation const simulation(pool({2, KernelName::wendland_c2, 1.2}, 0.0));
  EXPECT_TRUE(std::isnan(level_of(simulation, {{0.5, -0.1, 0.0}, {0.5, 0.1, 0.0}})));
}

TEST(LevelProbe, ALineThatEndsInTheFluidGivesItsEnd) {
  Simulation const simulation(pool({2, KernelName::wendland_c2, 1.2}, 0.0));
  EXPECT_DOUBLE_EQ(level_of(simulation, {{0.0, -0.15, 0.0}, {0.0, -0.1, 0.0}}), -0.1);
}

// Beside the end of the pool half of the kernel is missing in the depth as well.
TEST(LevelProbe, AtAVerticalEndTheSurfaceIsFoundToo) {
  Simulation const simulation(pool({2, KernelName::wendland_c2, 1.2}, 0.0));
  EXPECT_NEAR(level_of(simulation, {{0.2, -0.1, 0.0}, {0.2, 0.1, 0.0}}), 0.0, 0.1 * spacing);
}

}  // namespace
}  // namespace moraine
