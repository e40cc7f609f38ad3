// Shapes, trees of shapes, lattices and starts by their exact volumes, masses and pressures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "base/input_error.hpp"
#include "setup/fill.hpp"
#include "setup/geometry.hpp"
#include "setup/initial_state.hpp"
#include "support/bodies.hpp"

namespace moraine {
namespace {

constexpr double pi = std::numbers::pi;

Case case_of(int dimension, double spacing, Shape const& shape) {
  Case c;
  c.file = "case.toml";
  c.dimension = dimension;
  c.numerics.spacing = spacing;
  c.materials = {{"water", Tait{}}, {"sand", Tait{.reference_density = 2000.0}}};
  c.regions = {{"pool", "water", shape, {}}};
  c.domain = {{-4, -4, -4}, {4, 4, 4}};
  return c;
}

double filled_volume(Case const& c) {
  double mass = 0.0;
  for (Seed const& seed : fill_regions(c)) mass += seed.mass / seed.density;
  return mass;
}

StlBody body_of(std::vector<Triangle> const& triangles) {
  StlBody stl;
  TriangleMesh mesh = weld(triangles);
  MeshReport report = report_on(mesh);
  stl.body =
      std::make_shared<MeshBody const>(MeshBody{std::move(report), WindingNumber(std::move(mesh))});
  return stl;
}

// Lattice points in a convex body: off by less than half a layer of its surface.
void expect_volume(Case const& c, double volume, double surface) {
  EXPECT_NEAR(filled_volume(c), volume, 0.5 * c.numerics.spacing * surface);
}

TEST(Shapes, CylindersOfAnyAxisHaveTheirVolume) {
  for (Point const& axis :
       {Point{0, 0, 1}, Point{1, 0, 0}, Point{0.6, 0.0, 0.8}, Point{2.0 / 3, -1.0 / 3, 2.0 / 3}}) {
    Cylinder const cylinder{{0.1, 0.2, 0.3}, add({0.1, 0.2, 0.3}, axis), 0.4};
    Case const c = case_of(3, 0.05, cylinder);
    expect_volume(c, pi * 0.16, 2 * pi * 0.16 + 2 * pi * 0.4);
    Box const box = bounds(cylinder, 3);
    for (Seed const& seed : fill_regions(c)) EXPECT_TRUE(contains(box, seed.position, 3, 1e-9));
  }
  expect_volume(case_of(2, 0.02, Cylinder{{0, 0, 0}, {1, 1, 0}, 0.2}), 0.4 * std::sqrt(2.0),
                2 * std::sqrt(2.0) + 0.8);
}

TEST(Shapes, CylindersEndToEndShareNoPoint) {
  Case c = case_of(3, 0.1, Cylinder{{0, 0, 0.05}, {0, 0, 1.05}, 0.5});  // ends on lattice points
  std::size_t const one = fill_regions(c).size();
  c.regions[0].plus.push_back({Cylinder{{0, 0, 1.05}, {0, 0, 2.05}, 0.5}});
  EXPECT_EQ(fill_regions(c).size(), 2 * one);
}

TEST(Shapes, PolygonsHaveTheirArea) {
  Polygon const bank{{0, 0, 1, 0, 1, 0.25, 0.5, 0.5, 0, 0.75}, 2, {}, {}};
  EXPECT_DOUBLE_EQ(area(bank), 0.5);
  expect_volume(case_of(2, 0.005, bank), 0.5, 3.2);
  Polygon turned = bank;  // the other sense of rotation
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t k = 0; k < 2; ++k) turned.corners[2 * i + k] = bank.corners[2 * (4 - i) + k];
  EXPECT_EQ(fill_regions(case_of(2, 0.005, turned)).size(),
            fill_regions(case_of(2, 0.005, bank)).size());
}

TEST(Shapes, AnLOfWholeSpacingsIsFilledExactly) {
  Polygon const corner{{0, 0, 1, 0, 1, 0.5, 0.5, 0.5, 0.5, 1, 0, 1}, 2, {}, {}};
  EXPECT_EQ(fill_regions(case_of(2, 0.1, corner)).size(), 75U);
  Polygon through_points = corner;  // all sides run through lattice points
  for (double& place : through_points.corners) place += 0.05;
  EXPECT_EQ(fill_regions(case_of(2, 0.1, through_points)).size(), 75U);
}

TEST(Shapes, PrismsLieAcrossTheirAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    Polygon const wedge{{0, 0, 2, 0, 0, 1}, axis, -0.5, 1.0};
    Case const c = case_of(3, 0.05, wedge);
    expect_volume(c, 1.5, 2.0 + 1.5 * (3.0 + std::sqrt(5.0)));
    Box const box = bounds(wedge, 3);
    EXPECT_EQ(box.min[static_cast<std::size_t>(axis)], -0.5);
    EXPECT_EQ(box.max[axis == 0 ? 1 : 0], 2.0);
    for (Seed const& seed : fill_regions(c)) EXPECT_TRUE(contains(box, seed.position, 3, 1e-9));
  }
}

TEST(Shapes, BadPolygonsSayWhatIsWrong) {
  EXPECT_EQ(defect_of({{0, 0, 1, 0}, 2, {}, {}}), "has 2 corners; at least 3 are needed");
  EXPECT_EQ(defect_of({{0, 0, 1, 0, 1, 0, 0, 1}, 2, {}, {}}),
            "has corner 2 twice in a row, at (1, 0)");
  EXPECT_EQ(defect_of({{0, 0, 2, 0, 1, 0}, 2, {}, {}}),
            "folds back onto itself at corner 2, (2, 0)");
  EXPECT_EQ(defect_of({{0, 0, 1, 1, 1, 0, 0, 1}, 2, {}, {}}),
            "meets itself: the side from corner 1 at (0, 0) and the side from corner 3 at (1, 0)");
  EXPECT_EQ(defect_of({{0, 0, 1, 0, 2, 0, 2, 1}, 2, {}, {}}), "") << "a straight corner is none";
}

TEST(Shapes, TreesAddAndTakeAway) {
  Box const square{{0, 0, 0}, {1, 1, 0}};
  Case c = case_of(2, 0.1, square);
  c.regions[0].minus = {{Box{{0, 0, 0}, {0.5, 0.5, 0}}, {}, {{Box{{0, 0, 0}, {0.2, 0.2, 0}}}}}};
  EXPECT_EQ(fill_regions(c).size(), 100U - 25U + 4U) << "a hole with an island";
  c.regions[0].plus = {{Box{{1, 0, 0}, {2, 0.5, 0}}}, {Box{{0, 0, 0}, {0.5, 0.5, 0}}}};
  EXPECT_EQ(fill_regions(c).size(), 100U - 25U + 4U + 50U) << "minus takes from plus too";
  EXPECT_EQ(bounding_box_of_tree(c.regions[0], 2)->max, (Point{2, 1, 0}));
}

// A ring: what is taken away and what is left share no point and leave none out.
TEST(Shapes, DifferenceAndPartMakeTheWhole) {
  Case c = case_of(2, 0.013, Disc{{0, 0, 0}, 1.0});
  std::size_t const whole = fill_regions(c).size();
  c.regions[0].minus = {{Disc{{0.1, 0, 0}, 0.6}}};
  std::size_t const ring = fill_regions(c).size();
  Case const part = case_of(2, 0.013, Disc{{0.1, 0, 0}, 0.6});
  EXPECT_EQ(ring + fill_regions(part).size(), whole);
}

TEST(Stl, ACubeIsFilledLikeABox) {
  Box const box{{0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}};
  auto const sites = [](Case const& c) {
    std::vector<Point> points;
    for (Seed const& seed : fill_regions(c)) points.push_back(seed.position);
    return points;
  };
  Case stl = case_of(3, 0.1, body_of(cube({0.2, 0.2, 0.2}, 0.6)));
  Case plain = case_of(3, 0.1, box);
  plain.walls = stl.walls = {
      {"tank", WallForm::container, {{-0.05, -0.05, -0.05}, {2, 2, 2}}, {}, Slip::free}};
  EXPECT_EQ(sites(stl), sites(plain)) << "faces on lattice points";
  EXPECT_EQ(sites(stl).size(), 216U);
}

TEST(Stl, VolumesConvergeToThoseOfTheBodies) {
  for (auto const& triangles : {sphere(0.5, 24), torus(0.6, 0.25, 24)}) {
    double const exact = volume(triangles);
    double previous = exact;
    for (double const spacing : {0.1, 0.02}) {
      double const error = std::abs(filled_volume(case_of(3, spacing, body_of(triangles))) - exact);
      // Layers across z sum an area that ends like 4 pi R sqrt(2 r dz) at the top and bottom of the
      // torus, where the midpoint rule errs by up to 0.21 (zeta(-1/2)) dx^1.5 of the factor: 2.3
      // dx^1.5 for both; the rest is of higher order. The ball ends more gently.
      EXPECT_LT(error, 3.0 * std::pow(spacing, 1.5));
      EXPECT_LT(error, 0.5 * previous);
      previous = error;
    }
  }
}

TEST(Stl, BodiesTurnedInsideOutAreTheSame) {
  auto triangles = sphere(0.5, 12);
  std::size_t const particles = fill_regions(case_of(3, 0.1, body_of(triangles))).size();
  for (Triangle& t : triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(fill_regions(case_of(3, 0.1, body_of(triangles))).size(), particles);
}

TEST(Stl, OrderOfTrianglesChangesNoParticle) {
  auto triangles = torus(0.6, 0.25, 16);
  auto const first = fill_regions(case_of(3, 0.05, body_of(triangles)));
  std::reverse(triangles.begin(), triangles.end());
  auto const second = fill_regions(case_of(3, 0.05, body_of(triangles)));
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    ASSERT_EQ(first[i].position, second[i].position) << "to the bit";
}

TEST(Layers, LieFromTheTopDownwards) {
  Case c = case_of(2, 0.1, Box{{0, 0, 0}, {1, 1, 0}});
  c.gravity = {0, -9.81, 0};
  c.regions[0].material = "";
  c.regions[0].layers = {{"water", "sand", "water"}, {0.3, 0.5}, {}};
  std::size_t sand = 0;
  for (Seed const& seed : fill_regions(c)) {
    bool const middle = seed.position[1] > 0.2 && seed.position[1] < 0.7;
    EXPECT_EQ(seed.material, middle ? 1 : 0) << seed.position[1];
    sand += seed.material;
  }
  EXPECT_EQ(sand, 50U);
  c.regions[0].layers.thickness = {0.3, 0.5, 0.1};
  EXPECT_EQ(fill_regions(c).size(), 90U) << "nothing below the last";
  c.regions[0].layers.top = 0.95;  // a face through lattice points: the row on it is outside
  c.regions[0].layers.thickness = {0.3, 0.5};
  EXPECT_EQ(fill_regions(c).size(), 90U);
  c.gravity = {9.81, 0, 0};  // up is -x
  c.regions[0].layers = {{"sand", "water"}, {0.2}, {}};
  for (Seed const& seed : fill_regions(c)) EXPECT_EQ(seed.material, seed.position[0] < 0.2 ? 1 : 0);
}

TEST(Lattice, HexagonalBoxesHoldExactlyTheirMass) {
  for (double const spacing : {0.1, 0.03, 0.017}) {
    // 1e4 equal terms: rounding of the sum.
    Case c = case_of(2, spacing, Box{{0.3, -1, 0}, {1.3, 1, 0}});
    c.lattice = LatticeName::hexagonal;
    EXPECT_NEAR(filled_volume(c), 2.0, 1e-10) << spacing;
  }
  Case c = case_of(3, 0.1, Box{{0, 0, 0}, {1, 0.7, 1.3}});
  c.lattice = LatticeName::hexagonal;
  EXPECT_NEAR(filled_volume(c), 0.91, 1e-11);
}

// Nearest distances of the two lattices: sqrt(2/sqrt(3)) and 2^(1/6) spacings, stretched by less
// than half a layer of the ten or more that the box holds.
TEST(Lattice, HexagonalNeighboursStandAtTheirDistance) {
  for (int const dimension : {2, 3}) {
    Case c = case_of(dimension, 0.1, Box{{0, 0, 0}, {1, 1, dimension == 3 ? 1.0 : 0.0}});
    c.lattice = LatticeName::hexagonal;
    auto const seeds = fill_regions(c);
    auto const middle = std::min_element(seeds.begin(), seeds.end(), [&](auto& a, auto& b) {
      Point const center{0.5, 0.5, dimension == 3 ? 0.5 : 0.0};
      return length(subtract(a.position, center)) < length(subtract(b.position, center));
    });
    double const expected =
        0.1 * (dimension == 2 ? std::sqrt(2 / std::sqrt(3.0)) : std::pow(2.0, 1.0 / 6));
    auto const near = std::count_if(seeds.begin(), seeds.end(), [&](Seed const& seed) {
      double const r = length(subtract(seed.position, middle->position));
      return r > 0.0 && r < 1.2 * expected;
    });
    EXPECT_EQ(near, dimension == 2 ? 6 : 12);
  }
}

TEST(Lattice, HexagonalContinuesAcrossPeriodicSeams) {
  Case c = case_of(2, 0.1, HalfPlane{{9, 0, 0}, {1, 0, 0}});
  c.lattice = LatticeName::hexagonal;
  c.periodic = {true, true, false};
  c.domain = {{0, 0, 0}, {1, 1, 0}};
  auto const seeds = fill_regions(c);
  auto const x = [](double d) { return std::abs(d - std::round(d)); };  // period 1
  for (Seed const& a : seeds) {
    double nearest = 1.0;
    for (Seed const& b : seeds)
      if (&a != &b)
        nearest = std::min(nearest, std::hypot(x(a.position[0] - b.position[0]),
                                               x(a.position[1] - b.position[1])));
    EXPECT_NEAR(nearest, 0.1 * 1.0746, 0.008);
  }
  EXPECT_NEAR(filled_volume(c), 1.0, 1e-12);
}

TEST(Start, ARotationTurnsAboutItsAxis) {
  Case c = case_of(3, 0.25, Box{{0, 0, 0}, {1, 1, 1}});
  c.regions[0].initial.velocity = {7, 0, 0};
  c.regions[0].initial.rotation = {3.0, {1, 2, 0}, {0, 0, 5}};
  for (Seed const& seed : fill_regions(c)) {
    Point const& x = seed.position;
    EXPECT_NEAR(seed.velocity[0], 7 - 3 * (x[1] - 2), 1e-14);
    EXPECT_NEAR(seed.velocity[1], 3 * (x[0] - 1), 1e-14);
    EXPECT_EQ(seed.velocity[2], 0.0);
  }
}

// p = load + weight of what is above: water on two layers, exact on both lattices.
TEST(Start, LithostaticPressureIsTheWeightAbove) {
  for (auto const lattice : {LatticeName::square, LatticeName::hexagonal}) {
    Case c = case_of(2, 0.05, Box{{0, 0, 0}, {1, 1, 0}});
    c.lattice = lattice;
    c.gravity = {0, -10, 0};
    c.materials[0].eos = Tait{.reference_sound_speed = 100.0};
    c.materials[1].eos = Tait{.reference_density = 2000.0, .reference_sound_speed = 100.0};
    c.regions[0].material = "sand";
    c.regions[0].initial.lithostatic_load = 300.0;
    double const layer = make_lattice(c).layer(1);
    double const level = 12 * layer;  // the water begins between two layers of the lattice
    c.regions.push_back({"lake", "water", Box{{0, level, 0}, {1, 1, 0}}, {}});
    for (Seed const& seed : fill_regions(c)) {
      if (seed.material != 1) continue;
      double const exact = 300 + 10 * (1000 * (1 - level) + 2000 * (level - seed.position[1]));
      auto const& sand = std::get<Tait>(c.materials[1].eos);
      // Rounding of the density: 1e-16 rho c^2 = 2e-9 Pa, with a margin of 50.
      EXPECT_NEAR(sand.pressure(seed.density, seed.specific_energy), exact, 1e-7);
    }
  }
}

TEST(Fill, CountsWhatLaterRegionsReplace) {
  Case c = case_of(2, 0.1, Box{{0, 0, 0}, {1, 1, 0}});
  c.regions.push_back({"charge", "sand", Box{{0.4, 0.4, 0}, {0.6, 0.6, 0}}, {}});
  auto const counts = count_regions(c);
  EXPECT_EQ(counts[0].particles, 96U);
  EXPECT_EQ(counts[0].replaced, 4U);
  EXPECT_EQ(counts[1].particles, 4U);
  EXPECT_EQ(counts[1].replaced, 0U);
}

// Mirror images of a shape symmetric about the lattice have mirror images of its particles.
TEST(Fill, SymmetricShapesAreFilledSymmetrically) {
  Case c = case_of(2, 0.1, Disc{{0, 0, 0}, 0.95});
  c.regions[0].minus = {{Disc{{0, 0, 0}, 0.42}}};
  auto const seeds = fill_regions(c);
  for (Seed const& seed : seeds)
    EXPECT_TRUE(std::any_of(seeds.begin(), seeds.end(), [&](Seed const& other) {
      return std::abs(other.position[0] + seed.position[0]) < 1e-12 &&
             std::abs(other.position[1] - seed.position[1]) < 1e-12;
    }));
}

}  // namespace
}  // namespace moraine
