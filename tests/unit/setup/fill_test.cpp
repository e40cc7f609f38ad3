#include "setup/fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/input_error.hpp"
#include "setup/geometry.hpp"
#include "setup/initial_state.hpp"

namespace moraine {
namespace {

Case box_case(int dimension, double spacing, Box const& box) {
  Case c;
  c.file = "case.toml";
  c.dimension = dimension;
  c.numerics.spacing = spacing;
  c.materials = {{"water", WaterPolynomial{}}, {"tnt", Jwl{}}};
  c.regions = {{"pool", "water", box, {}}};
  c.domain = *default_domain(c);
  return c;
}

double total_mass(std::vector<Seed> const& seeds, MaterialId material) {
  return std::accumulate(seeds.begin(), seeds.end(), 0.0, [&](double sum, Seed const& seed) {
    return sum + (seed.material == material ? seed.mass : 0.0);
  });
}

std::size_t count(std::vector<Seed> const& seeds, MaterialId material) {
  return static_cast<std::size_t>(std::count_if(
      seeds.begin(), seeds.end(), [&](auto const& seed) { return seed.material == material; }));
}

TEST(Fill, CommensurateBoxesFillExactlyWhereverTheyLie) {
  // 0.1 and 0.01 have no exact doubles; the corners add rounding of their own.
  for (double const x : {0.0, 0.1, 0.3, -0.7, 1.1, 12.3}) {
    Box const box{{x, -x, 0}, {x + 0.1, -x + 0.1, 0}};
    EXPECT_EQ(fill_regions(box_case(2, 0.01, box)).size(), 100U) << x;
  }
  EXPECT_EQ(fill_regions(box_case(1, 0.001, {{0.2, 0, 0}, {0.3, 0, 0}})).size(), 100U);
  EXPECT_EQ(fill_regions(box_case(3, 0.1, {{0, 0, 0}, {0.3, 0.4, 0.5}})).size(), 60U);
}

TEST(Fill, PointsLieInTheMiddleOfTheirCells) {
  auto const seeds = fill_regions(box_case(2, 0.5, {{1, 2, 0}, {2, 3, 0}}));
  ASSERT_EQ(seeds.size(), 4U);
  EXPECT_EQ(seeds[0].position, (Point{1.25, 2.25, 0}));
  EXPECT_EQ(seeds[1].position, (Point{1.75, 2.25, 0}));
  EXPECT_EQ(seeds[2].position, (Point{1.25, 2.75, 0}));
}

TEST(Fill, MassIsDensityTimesVolume) {
  Case c = box_case(3, 0.1, {{0, 0, 0}, {0.3, 0.4, 0.5}});
  c.regions[0].initial.velocity = {1, 2, 3};
  auto const seeds = fill_regions(c);
  // 60 equal terms: rounding of the sum stays below 60 * 1.1e-16.
  EXPECT_NEAR(total_mass(seeds, 0), 1000.0 * 0.06, 1e-14 * 60.0);
  EXPECT_EQ(seeds[0].density, 1000.0);
  EXPECT_EQ(seeds[0].specific_energy, 357.1);
  EXPECT_EQ(seeds[0].velocity, (Point{1, 2, 3}));
}

TEST(Fill, LaterRegionsReplaceEarlier) {
  Case c = box_case(2, 0.01, {{0, 0, 0}, {1, 1, 0}});
  c.regions.push_back({"charge", "tnt", Box{{0.45, 0.45, 0}, {0.55, 0.55, 0}}, {}});
  auto const seeds = fill_regions(c);
  EXPECT_EQ(count(seeds, 0), 9900U);
  EXPECT_EQ(count(seeds, 1), 100U);
  EXPECT_NEAR(total_mass(seeds, 1), 16.3, 1e-12);  // kg per metre; 100 terms
}

TEST(Fill, DiscsAndHalfPlanesKeepTheirVolume) {
  Case c = box_case(2, 0.01, {{0, 0, 0}, {1, 1, 0}});
  c.regions[0].shape = Disc{{0.5, 0.5, 0}, 0.3};
  // Lattice points in a circle of 30 spacings: pi r^2 = 2827.4, off by less than the perimeter / 2.
  EXPECT_NEAR(static_cast<double>(fill_regions(c).size()), 2827.4, 94.0);
  c.domain = {{0, 0, 0}, {1, 1, 0}};
  c.regions[0].shape = HalfPlane{{0, 0.295, 0}, {0, 1, 0}};
  EXPECT_EQ(fill_regions(c).size(), 3000U);  // the row on the plane belongs to it
}

TEST(Fill, WallsBoundTheFluid) {
  Case c = box_case(2, 0.1, {{-1, -1, 0}, {3, 3, 0}});
  WallSpec const tank{"tank", WallForm::container, {{0, 0, 0}, {1, 1, 0}}, {}, Slip::free};
  c.walls = {tank};
  EXPECT_EQ(lattice_anchor(c), (Point{0, 0, 0}));
  EXPECT_EQ(fill_regions(c).size(), 100U);
  c.walls[0].open[1][1] = true;  // up to the end of the region
  EXPECT_EQ(fill_regions(c).size(), 300U);
  c.walls = {tank, {"step", WallForm::solid, {{0.4, 0, 0}, {0.6, 0.3, 0}}, {}, Slip::free}};
  EXPECT_EQ(fill_regions(c).size(), 94U);
  WallSpec second = tank;
  second.box = {{2, 0, 0}, {3, 1, 0}};
  c.walls = {tank, second};
  EXPECT_EQ(fill_regions(c).size(), 200U);
}

TEST(Fill, PeriodicSeamIsFilledOnce) {
  Case c = box_case(1, 0.1, {{0, 0, 0}, {1, 0, 0}});
  c.domain = {{0.05, 0, 0}, {1.05, 0, 0}};  // both ends on lattice points
  c.regions[0].shape = HalfPlane{{9, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(lattice_anchor(c), (Point{0, 0, 0}));
  EXPECT_EQ(fill_regions(c).size(), 10U);
}

TEST(Fill, RegionsWithoutParticlesAreInputErrors) {
  Case c = box_case(2, 0.1, {{0, 0, 0}, {1, 1, 0}});
  c.regions.insert(c.regions.begin(), {"under", "tnt", Box{{0, 0, 0}, {0.5, 0.5, 0}}, {}});
  c.regions.push_back({"tiny", "tnt", Disc{{0.5, 0.5, 0}, 0.01}, {}});
  c.regions.push_back({"cold", "tnt", Box{{0, 0, 0}, {0.2, 0.2, 0}}, {}});
  c.regions.back().initial.pressure = -1e9;
  try {
    fill_regions(c);
    FAIL() << "no error";
  } catch (InputErrors const& errors) {
    EXPECT_STREQ(errors.what(),
                 "case.toml: region.under: fills no particle at a spacing of 0.1 m; it is too "
                 "small, outside the walls or covered by a later region\n"
                 "case.toml: region.tiny: fills no particle at a spacing of 0.1 m; it is too "
                 "small, outside the walls or covered by a later region\n"
                 "case.toml: region.cold.pressure: asks for a pressure that the material "
                 "\"tnt\" cannot have");
  }
}

Case still_water() {
  Case c = box_case(2, 0.1, {{0, 0, 0}, {1, 1.5, 0}});
  c.gravity = {0, -9.81, 0};
  c.materials[0].eos = Tait{.reference_sound_speed = 30.0};
  c.regions[0].initial.hydrostatic_level = 1.0;  // the rows above the level have no pressure
  return c;
}

TEST(Fill, HydrostaticLayersCarryTheWeightAboveThem) {
  Case const c = still_water();
  Tait const tait = std::get<Tait>(c.materials[0].eos);
  auto const seeds = fill_regions(c);
  ASSERT_EQ(seeds.size(), 150U);
  double face = 0.0;  // of the row below
  for (std::size_t row = 0; row < 15; ++row) {
    Seed const& seed = seeds[10 * row + 3];
    EXPECT_EQ(seed.mass, 1000.0 * std::pow(0.1, 2)) << row;  // of all, for the sweep of one liquid
    double const weight = 1000.0 * 9.81 * std::max(0.0, 0.95 - 0.1 * static_cast<double>(row));
    // Rounding of the density, 1e-16 rho c^2 = 1e-10 Pa, with a margin of 100.
    EXPECT_NEAR(tait.pressure(seed.density, seed.specific_energy), weight, 1e-8) << row;
    double const thickness = seed.mass / (seed.density * 0.1);
    EXPECT_NEAR(seed.position[1], face + 0.5 * thickness, 1e-14) << row;
    EXPECT_DOUBLE_EQ(seed.position[0], 0.35) << row;
    face += thickness;
  }
  EXPECT_LT(face, 1.5 - 0.004);  // 1 m shrinks by g H^2 / (2 c^2) = 5.5 mm
}

// Columns above a step, below a lid or around a body would sink by different amounts.
TEST(Fill, HydrostaticLatticeStaysEvenWhereColumnsDoNotStandFree) {
  WallSpec const step{"step", WallForm::solid, {{0.0, 0, 0}, {0.5, 0.3, 0}}, {}, Slip::free};
  WallSpec const body{"body", WallForm::solid, {{0.2, 0.4, 0}, {0.5, 0.7, 0}}, {}, Slip::free};
  for (WallSpec const& wall : {step, body}) {
    Case c = still_water();
    c.walls.push_back(wall);
    for (Seed const& seed : fill_regions(c)) {
      double const row = seed.position[1] / 0.1 - 0.5;
      EXPECT_NEAR(row, std::round(row), 1e-12) << wall.name;
      EXPECT_DOUBLE_EQ(seed.mass, seed.density * std::pow(0.1, 2)) << wall.name;
    }
  }
  Case lid = still_water();
  lid.regions[0].initial.hydrostatic_level = 2.0;
  for (Seed const& seed : fill_regions(lid))
    EXPECT_DOUBLE_EQ(seed.mass, seed.density * std::pow(0.1, 2)) << "under a lid";
}

TEST(Fill, HydrostaticLayersFollowGravityAlongItsAxis) {
  Case c = still_water();
  auto const fallen = fill_regions(c);
  c.gravity = {0, 9.81, 0};  // down is y+: the lower face of the region is at y = 1.5
  c.regions[0].initial.hydrostatic_level = -0.5;
  auto const risen = fill_regions(c);
  ASSERT_EQ(risen.size(), fallen.size());
  for (std::size_t row = 0; row < 15; ++row)
    EXPECT_NEAR(risen[10 * (14 - row)].position[1], 1.5 - fallen[10 * row].position[1], 1e-13);
}

TEST(Fill, WithoutLayersTheMassFollowsTheDensity) {
  Case oblique = still_water();
  oblique.gravity = {-3, -9, 0};
  Case other = still_water();
  other.materials[0].eos = WaterPolynomial{};
  for (Case const& c : {oblique, other})
    for (auto const& seed : fill_regions(c)) {
      EXPECT_DOUBLE_EQ(seed.mass, seed.density * 0.01);
      double const row = seed.position[1] / 0.1 - 0.5;
      EXPECT_NEAR(row, std::round(row), 1e-12);
    }
}

TEST(Fill, HydrostaticLevelFollowsTiltedGravity) {
  Point const gravity{-3.0, 0.0, -4.0};  // |g| = 5, up = (0.6, 0, 0.8)
  EXPECT_DOUBLE_EQ(hydrostatic_pressure(1000.0, 2.0, {1, 7, 0.5}, gravity), 5000.0);
  EXPECT_EQ(hydrostatic_pressure(1000.0, 2.0, {3, 0, 3}, gravity), 0.0);
}

TEST(InitialState, SolvesWhatIsMissing) {
  InitialState initial;
  initial.pressure = 1e9;
  auto const dense = initial_state(WaterPolynomial{}, initial, {}, {});
  ASSERT_TRUE(dense);
  EXPECT_EQ(dense->specific_energy, 357.1);
  EXPECT_NEAR(WaterPolynomial{}.pressure(dense->density, 357.1), 1e9, 1.0);  // 1e-9 p
  initial.density = 1000.0;
  auto const hot = initial_state(WaterPolynomial{}, initial, {}, {});
  ASSERT_TRUE(hot);
  EXPECT_EQ(hot->density, 1000.0);
  EXPECT_NEAR(hot->specific_energy, 1e9 / 0.4934 / 1000.0, 1e-6);  // p = b0 rho_0 e at rho_0
}

TEST(InitialState, PressuresThatCannotBeGiveNothing) {
  InitialState initial;
  initial.pressure = 5.0;
  initial.density = 1000.0;  // Tait: the pressure at rho_0 is 0 whatever the energy
  EXPECT_EQ(initial_state(Tait{}, initial, {}, {}).has_value(), false);
  initial.density.reset();
  EXPECT_TRUE(initial_state(Tait{}, initial, {}, {}).has_value());
  initial.pressure = -1.0;
  EXPECT_FALSE(initial_state(IdealGas{}, initial, {}, {}).has_value());
}

}  // namespace
}  // namespace moraine
