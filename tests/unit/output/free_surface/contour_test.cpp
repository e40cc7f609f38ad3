// Surfaces of balls and discs of particles are closed, and as large as they should be.
#include "output/free_surface/contour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace moraine {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Vec3 middle{0.37, -0.12, 0.05};
constexpr Vec3 middle_2d{0.37, -0.12, 0.0};

/// Particles on a lattice inside of a ball (disc) of radius 1, each with its share of the volume.
Blobs ball(int dimension, double spacing) {
  Blobs blobs;
  blobs.dimension = dimension;
  int const n = static_cast<int>(1.0 / spacing) + 1;
  int const depth = dimension == 3 ? n : 0;
  for (int k = -depth; k <= depth; ++k)
    for (int j = -n; j <= n; ++j)
      for (int i = -n; i <= n; ++i) {
        Vec3 const x{(i + 0.5) * spacing, (j + 0.5) * spacing,
                     dimension == 3 ? (k + 0.5) * spacing : 0.0};
        if (norm(x) < 1.0) blobs.place.push_back(add(x, dimension == 3 ? middle : middle_2d));
      }
  double const whole = dimension == 3 ? 4.0 / 3.0 * pi : pi;
  blobs.volume.assign(blobs.place.size(), whole / static_cast<double>(blobs.place.size()));
  blobs.h.assign(blobs.place.size(), 1.2 * spacing);
  return blobs;
}

/// Particles on spheres a spacing apart, spread over each along a spiral: a ball without the steps
/// that a sphere cuts into a lattice.
Blobs onion(double spacing) {
  Blobs blobs;
  for (double outer = 1.0; outer > 0.5 * spacing; outer -= spacing) {
    double const inner = std::max(0.0, outer - spacing);
    double const radius = 0.5 * (outer + inner);
    double const volume = 4.0 / 3.0 * pi * (outer * outer * outer - inner * inner * inner);
    int const count = static_cast<int>(std::lround(volume / (spacing * spacing * spacing)));
    for (int k = 0; k < count; ++k) {
      double const z = 1.0 - 2.0 * (k + 0.5) / count;
      double const turn = pi * (3.0 - std::sqrt(5.0)) * k;
      double const across = std::sqrt(1.0 - z * z);
      blobs.place.push_back(
          add(scale(radius, {across * std::cos(turn), across * std::sin(turn), z}), middle));
      blobs.volume.push_back(volume / count);
      blobs.h.push_back(1.2 * spacing);
    }
  }
  return blobs;
}

Contour surface(int dimension, double spacing, double share = 0.5) {
  return contour_at(filled_grid(ball(dimension, spacing), KernelName::wendland_c2, 0.6 * spacing),
                    share);
}

/// How often an edge is passed one way and the other way.
bool is_closed(Contour const& contour) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> passed;
  for (std::size_t k = 0; k < contour.cells.size(); k += 3)
    for (std::size_t c = 0; c < 3; ++c)
      ++passed[{contour.cells[k + c], contour.cells[k + (c + 1) % 3]}];
  for (auto const& [edge, count] : passed) {
    auto const back = passed.find({edge.second, edge.first});
    if (count != 1 || back == passed.end() || back->second != 1) return false;
  }
  return !passed.empty();
}

/// Relative errors of area and volume.
std::pair<double, double> errors(Contour const& contour) {
  return {std::abs(size_of(contour) / (4.0 * pi) - 1.0),
          std::abs(content_of(contour) / (4.0 / 3.0 * pi) - 1.0)};
}

// The surface s = 1/2 of a ball lies about h^2 / r inside of it.
TEST(Contour, OfABallIsClosedAndAsLargeAsTheBall) {
  double last_area = std::numeric_limits<double>::infinity();
  double last_volume = last_area;
  for (double const spacing : {0.2, 0.1, 0.05}) {
    Contour const contour =
        contour_at(filled_grid(onion(spacing), KernelName::wendland_c2, 0.6 * spacing), 0.5);
    EXPECT_TRUE(is_closed(contour)) << "spacing " << spacing;
    auto const [area, volume] = errors(contour);
    EXPECT_LT(area, 2.0 * spacing * spacing);
    EXPECT_LT(volume, 2.0 * spacing * spacing);
    EXPECT_LT(area, last_area);
    EXPECT_LT(volume, last_volume);
    last_area = area;
    last_volume = volume;
  }
}

// A sphere cuts steps into a lattice, whose slopes stay while they get smaller: the volume
// converges, the area is that of a rough surface.
TEST(Contour, OfABallOfALatticeIsClosedAndRough) {
  double last = std::numeric_limits<double>::infinity();
  for (double const spacing : {0.2, 0.1, 0.05}) {
    Contour const contour = surface(3, spacing);
    EXPECT_TRUE(is_closed(contour)) << "spacing " << spacing;
    auto const [area, volume] = errors(contour);
    EXPECT_LT(area, 0.02);
    EXPECT_LT(volume, 1.5 * spacing * spacing);
    EXPECT_LT(volume, last);
    last = volume;
  }
}

TEST(Contour, NormalsPointOutwards) {
  Contour const contour = surface(3, 0.1);
  ASSERT_EQ(contour.normals.size(), contour.points.size());
  for (std::size_t k = 0; k < contour.points.size(); ++k) {
    Vec3 const outward = subtract(contour.points[k], middle);
    EXPECT_NEAR(norm(contour.normals[k]), 1.0, 1e-12);
    EXPECT_GT(dot(contour.normals[k], outward) / norm(outward), 0.8);
  }
  EXPECT_GT(content_of(contour), 0.0) << "triangles turn the right way";
}

TEST(Contour, OfADiscIsAClosedLineRoundIt) {
  for (double const spacing : {0.1, 0.05}) {
    Contour const contour = surface(2, spacing);
    std::map<std::uint32_t, int> begins, ends;
    for (std::size_t k = 0; k < contour.cells.size(); k += 2) {
      ++begins[contour.cells[k]];
      ++ends[contour.cells[k + 1]];
    }
    EXPECT_EQ(begins.size(), contour.points.size());
    for (auto const& [point, count] : begins) EXPECT_EQ(count, 1);
    for (auto const& [point, count] : ends) EXPECT_EQ(count, 1);
    EXPECT_EQ(ends.size(), contour.points.size());
    EXPECT_NEAR(content_of(contour) / pi, 1.0, spacing * spacing + 0.05 * spacing);
    EXPECT_NEAR(size_of(contour) / (2.0 * pi), 1.0, 0.03) << "rough, as the lattice cuts it";
  }
}

TEST(Contour, MovesOutwardsForASmallerShare) {
  EXPECT_GT(content_of(surface(3, 0.1, 0.25)), content_of(surface(3, 0.1, 0.5)));
}

TEST(Contour, OfNothingIsEmpty) {
  EXPECT_TRUE(contour_at(filled_grid({}, KernelName::wendland_c2, 1.0), 0.5).points.empty());
}

TEST(Contour, RefusesAGridThatIsTooLarge) {
  Blobs two = ball(3, 0.5);
  two.place.back()[0] = 1e9;
  EXPECT_THROW(filled_grid(two, KernelName::wendland_c2, 0.1), std::runtime_error);
}

}  // namespace
}  // namespace moraine
