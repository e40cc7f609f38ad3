// Craters of known shape in particles, with pieces that fly above them.
#include "probes/crater_probe.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "probes/connected_body.hpp"
#include "support/carved_ground.hpp"

namespace moraine {
namespace {

constexpr double radius = 0.2;  // m, at the original level
constexpr double depth = 0.1;
constexpr double rim = 0.03;  // m, height

/// A paraboloid that goes on upwards to its rim; outside, the ground falls back to its level.
double rimmed(double r) {
  double const inside = depth * (r * r / (radius * radius) - 1.0);
  double const crest = radius * std::sqrt(1.0 + rim / depth);
  return r < crest ? inside : std::max(0.0, rim - 0.5 * (r - crest));
}

double plain(double r) { return std::min(0.0, depth * (r * r / (radius * radius) - 1.0)); }

double exact_volume(int dimension) {
  return dimension == 3 ? 0.5 * std::numbers::pi * radius * radius * depth
                        : 4.0 / 3.0 * radius * depth;
}

struct Found {
  CraterReading crater;
  ConnectedBody body;
};

Found find(int dimension, double spacing, double (*height)(double), bool half = false) {
  Case c = ground_case(dimension, spacing, 0.4, 0.16, 0.04, 0.1);
  if (half) {
    c.domain.min[0] = 0.0;
    c.regions[0].shape = [&] {
      Box box = std::get<Box>(c.regions[0].shape);
      box.min[0] = 0.0;
      return box;
    }();
    c.symmetry.planes[0][0] = true;
  }
  Simulation const simulation(carved(c, 0.1, height));
  ParticleStore const& store = simulation.particles();
  double const h = c.numerics.smoothing_length();
  Found found;
  found.body = connected_body(store, simulation.search(), h, Selection{}.of(store));
  BodyView const view{store, simulation.search(), c.numerics.kernel,
                      h,     found.body.members,  {static_cast<std::size_t>(dimension - 1), 1.0}};
  found.crater = probe_crater(view, {0.0, Vec3{}, std::numeric_limits<double>::infinity(), 16,
                                     c.domain.min, c.domain.max, spacing});
  return found;
}

class Crater : public testing::TestWithParam<int> {};

// Rows of the lattice lie up to half a spacing from the true surface, which has a slope of 1 at
// the edge: so does the radius. Over the whole surface this averages out, and the volume errs by 5
// % and 2.5 % at most, with 10 and 20 spacings per radius.
TEST_P(Crater, IsMeasuredToASpacing) {
  int const dimension = GetParam();
  for (double const spacing : {0.02, 0.01}) {
    auto const [crater, body] = find(dimension, spacing, rimmed);
    EXPECT_NEAR(0.5 * crater.apparent_diameter, radius, 0.6 * spacing);
    EXPECT_NEAR(crater.depth, depth, 0.5 * spacing);
    EXPECT_NEAR(crater.rim_height, rim, 0.75 * spacing);
    EXPECT_NEAR(crater.rim_diameter, 2.0 * radius * std::sqrt(1.0 + rim / depth), 1.5 * spacing);
    EXPECT_NEAR(crater.volume / exact_volume(dimension), 1.0, 2.5 * spacing);
    EXPECT_EQ(body.detached, dimension == 3 ? 125U : 25U);
  }
}

// Without a rim the crater ends where its depth falls below a quarter of the spacing: inside of
// the true end, here with a slope of 1, by that and by what the kernel rounds off.
TEST_P(Crater, WithoutARimEndsWhereTheGroundIsFlat) {
  double const spacing = 0.02;
  auto const [crater, body] = find(GetParam(), spacing, plain);
  EXPECT_NEAR(0.5 * crater.apparent_diameter, radius, 0.75 * spacing);
  EXPECT_EQ(crater.rim_diameter, crater.apparent_diameter);
  EXPECT_EQ(crater.rim_height, 0.0);
}

TEST_P(Crater, FlatGroundHasNone) {
  auto const [crater, body] = find(GetParam(), 0.02, [](double) { return 0.0; });
  EXPECT_EQ(crater.depth, 0.0);
  EXPECT_EQ(crater.apparent_diameter, 0.0);
  EXPECT_EQ(crater.volume, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Crater, testing::Values(2, 3));

// Half of it beyond a symmetry plane through the axis: the same particles are seen.
TEST(CraterProbe, HalfOfItGivesTheWhole) {
  auto const whole = find(2, 0.02, rimmed).crater;
  auto const half = find(2, 0.02, rimmed, true).crater;
  EXPECT_NEAR(half.apparent_diameter, whole.apparent_diameter, 1e-5);
  EXPECT_NEAR(half.volume, whole.volume, 1e-5 * whole.volume);
  EXPECT_NEAR(half.depth, whole.depth, 1e-5);
}

}  // namespace
}  // namespace moraine
