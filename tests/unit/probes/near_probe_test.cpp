// A probe that asks the cells of the search agrees with one that asks all particles.
#include <gtest/gtest.h>

#include <cmath>

#include "probes/point_probe.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

// Both sum the same numbers in another order: some tens of roundings.
void expect_same(PointState const& a, PointState const& b) {
  auto const near = [](double x, double y, double size) {
    if (std::isnan(y)) {
      EXPECT_TRUE(std::isnan(x));
      return;
    }
    EXPECT_NEAR(x, y, 1e-13 * size);
  };
  near(a.density, b.density, 1e3);
  near(a.pressure, b.pressure, 1e7);
  near(a.specific_energy, b.specific_energy, 1e3);
  for (std::size_t axis = 0; axis < 3; ++axis) near(a.velocity[axis], b.velocity[axis], 1e2);
}

class NearProbe : public testing::TestWithParam<int> {};

TEST_P(NearProbe, SeesAllParticlesNearbyBetweenRebuildsToo) {
  int const dimension = GetParam();
  Simulation simulation(small_dam_break(dimension, Precision::full, 1.0));
  Model const& model = simulation.model();
  double const h = model.numerics.smoothing_length();
  bool kept = false;
  for (int step = 0; step < 40; ++step) {
    auto const rebuilds = simulation.search().rebuilds();
    simulation.advance();
    kept = kept || simulation.search().rebuilds() == rebuilds;
    for (double const x : {-0.05, 0.0, 0.013, 0.2, 0.39, 0.43, 0.7, 5.0})
      for (double const y : {0.0, 0.1, 0.21}) {
        std::array<double, 3> const place{x, y, y};
        expect_same(probe_point(simulation.particles(), simulation.search(), model.numerics.kernel,
                                h, place),
                    probe_point(simulation.particles(), model.numerics.kernel, h, place));
      }
  }
  EXPECT_TRUE(kept);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, NearProbe, testing::Values(2, 3));

// Across a periodic side: the state of a place and of the same place a period away.
TEST(NearProbeAcross, PeriodicSides) {
  RandomBox box;
  box.side = 16;
  Simulation simulation(random_box(box, 1.0));
  for (int step = 0; step < 10; ++step) simulation.advance();
  Model const& model = simulation.model();
  double const h = model.numerics.smoothing_length();
  double const period = model.domain_max[0];
  for (double const y : {0.001, 0.08})
    for (double const x : {0.0, 0.003, 0.08}) {
      auto const at = [&](double left) {
        return probe_point(simulation.particles(), simulation.search(), model.numerics.kernel, h,
                           {left, y, 0.0});
      };
      expect_same(at(x + period), at(x));
      EXPECT_NEAR(at(x).density, 2000.0, 1100.0);  // 1000 and 3000 kg/m^3 meet there
    }
}

}  // namespace
}  // namespace moraine
