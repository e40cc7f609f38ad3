// Neighbour lists are complete: against all pairs, at once and after motion within the skin.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "smoothing/pair_smoothing.hpp"
#include "step/simulation_setup.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

std::array<double, 3> position(ParticleStore const& store, std::size_t i) {
  std::array<double, 3> x{};
  for (int axis = 0; axis < store.dimension(); ++axis)
    x[static_cast<std::size_t>(axis)] = store.component(Field::position, axis)[i];
  return x;
}

/// Distance of two places, the nearest images counting.
double distance(Model const& model, std::array<double, 3> const& a,
                std::array<double, 3> const& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(model.dimension); ++axis) {
    double d = a[axis] - b[axis];
    double const period = model.domain_max[axis] - model.domain_min[axis];
    if (model.periodic[axis]) d -= period * std::round(d / period);
    sum += d * d;
  }
  return std::sqrt(sum);
}

/// Points of `kind` that list entry `listed` stands for.
std::size_t owner(Search const& search, Kind kind, std::size_t owned, std::uint32_t listed) {
  return listed < owned ? listed : search.images(kind)[listed - owned].source;
}

/// Support of a pair [m]; particles count from the first of the store.
double support_of(Model const& model, SearchSettings const& settings, std::size_t i,
                  std::size_t j) {
  Smoothing const& smoothing = model.numerics.smoothing;
  if (!smoothing.varies()) return settings.support;
  auto const h = model.particles.scalar(Field::smoothing_length);
  // A wall particle has none; against it, a particle has at least that of the case.
  if (i >= h.size() || j >= h.size())
    return std::max(settings.support, kernel_support * h[std::min(i, j)]);
  return kernel_support * pair_smoothing(smoothing.of_pair, h[i], h[j]);
}

/// Everything nearer than the support (less one part in a million for fixed point) is listed, once.
void expect_complete(Model const& model, Search const& search, NeighbourList const& lists, Kind of,
                     Kind among) {
  ParticleStore const& store = model.particles;
  Range const self = store.range(of);
  Range const others = store.range(among);
  ASSERT_EQ(lists.size(), self.size());
  std::size_t found = 0;
  for (std::size_t i = 0; i < self.size(); ++i) {
    std::vector<std::size_t> listed;
    for (std::uint32_t const j : lists.points(i))
      listed.push_back(owner(search, among, others.size(), j));
    std::sort(listed.begin(), listed.end());
    EXPECT_EQ(std::adjacent_find(listed.begin(), listed.end()), listed.end()) << "twice, of " << i;
    for (std::size_t j = 0; j < others.size(); ++j) {
      if (of == among && i == j) continue;
      std::size_t const a = self.begin + i;
      std::size_t const b = others.begin + j;
      if (distance(model, position(store, a), position(store, b)) >=
          support_of(model, search.settings(), a, b) * (1.0 - 1e-6))
        continue;
      ++found;
      ASSERT_TRUE(std::binary_search(listed.begin(), listed.end(), j)) << i << " misses " << j;
    }
  }
  EXPECT_GT(found, 0u);
}

void expect_all_complete(Model const& model, Search const& search) {
  expect_complete(model, search, search.fluid_fluid(), Kind::fluid, Kind::fluid);
  if (model.particles.range(Kind::wall).size() == 0) return;
  expect_complete(model, search, search.fluid_wall(), Kind::fluid, Kind::wall);
  expect_complete(model, search, search.wall_fluid(), Kind::wall, Kind::fluid);
}

RandomBox box_of(int dimension) {
  RandomBox box;
  box.dimension = dimension;
  box.side = std::array{0, 100, 16, 8}[static_cast<std::size_t>(dimension)];
  return box;
}

/// Dimension, and how smoothing lengths of pairs are found where they vary.
using Supports = std::pair<int, std::optional<PairSmoothing>>;

class SearchOf : public testing::TestWithParam<Supports> {
 protected:
  static Model model_with(bool walls) {
    auto const& [dimension, of_pair] = GetParam();
    Model model =
        walls ? walled_random_box(box_of(dimension), 1.0) : random_box(box_of(dimension), 1.0);
    if (!of_pair) return model;
    model.numerics.smoothing.mode = SmoothingMode::density;
    model.numerics.smoothing.of_pair = *of_pair;
    model.particles.use(Field::smoothing_length);
    auto h = model.particles.scalar(Field::smoothing_length);
    for (std::size_t i = 0; i < h.size(); ++i)
      h[i] = model.numerics.smoothing_length() * (1.0 + 0.4 * std::sin(11.0 * double(i)));
    return model;
  }
};

TEST_P(SearchOf, FindsAllNeighbours) {
  for (bool const walls : {false, true}) {
    Model model = model_with(walls);
    Search search(search_settings(model));
    ASSERT_TRUE(search.refresh(model.particles));
    expect_all_complete(model, search);
  }
}

// Particles walk at random by steps far below the skin: some refreshes must keep the lists, some
// must rebuild them, and all must leave them complete.
TEST_P(SearchOf, StaysCompleteWhileParticlesMove) {
  for (bool const walls : {false, true}) {
    Model model = model_with(walls);
    Search search(search_settings(model));
    search.refresh(model.particles);
    int kept = 0;
    for (int step = 0; step < 20; ++step) {
      ParticleStore& store = model.particles;
      for (int axis = 0; axis < model.dimension; ++axis)
        for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
          store.component(Field::position, axis)[i] +=
              4e-5 * std::sin(static_cast<double>(7 * store.id()[i] + 3u) + axis);
      for (std::size_t i = 0; i < store.scalar(Field::smoothing_length).size(); ++i)
        store.scalar(Field::smoothing_length)[i] *= 1.0 + 1e-3 * std::sin(double(store.id()[i]));
      kept += search.refresh(store) ? 0 : 1;
      expect_all_complete(model, search);
    }
    EXPECT_GT(kept, 0);
    EXPECT_LT(kept, 20);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Dimensions, SearchOf,
    testing::Values(Supports{1, {}}, Supports{2, {}}, Supports{3, {}},
                    Supports{1, PairSmoothing::arithmetic}, Supports{2, PairSmoothing::arithmetic},
                    Supports{3, PairSmoothing::arithmetic}, Supports{2, PairSmoothing::geometric},
                    Supports{2, PairSmoothing::largest}, Supports{3, PairSmoothing::largest},
                    Supports{2, PairSmoothing::smallest}));

}  // namespace
}  // namespace moraine
