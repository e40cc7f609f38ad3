// Removing particles keeps the others, their fields and the kinds apart.
#include <gtest/gtest.h>

#include <tuple>
#include <vector>

#include "store/particle_store.hpp"

namespace moraine {
namespace {

ParticleStore filled(int fluid, int walls) {
  ParticleStore store(2);
  for (int i = 0; i < fluid + walls; ++i) {
    bool const wall = i >= fluid;
    std::size_t const k = store.append(wall ? Kind::wall : Kind::fluid, wall ? no_material : 0);
    store.component(Field::position, 1)[k] = i;
    if (!wall) store.scalar(Field::mass)[k] = i;
  }
  return store;
}

TEST(Remove, KeepsTheOthersOfBothKinds) {
  using Indices = std::vector<std::uint32_t>;
  for (auto const& [gone, fluid, walls] :
       {std::tuple(Indices{}, 5U, 3U), std::tuple(Indices{3, 4}, 3U, 3U),
        std::tuple(Indices{0, 1, 2, 3, 4}, 0U, 3U), std::tuple(Indices{0, 4, 5, 7}, 3U, 1U),
        std::tuple(Indices{5, 6, 7}, 5U, 0U)}) {
    ParticleStore store = filled(5, 3);
    store.remove(gone);
    EXPECT_EQ(store.range(Kind::fluid).size(), fluid);
    EXPECT_EQ(store.range(Kind::wall).size(), walls);
    EXPECT_EQ(store.size(), fluid + walls);
    EXPECT_EQ(store.scalar(Field::mass).size(), fluid);
    for (std::size_t i = 0; i < store.size(); ++i) {
      auto const id = static_cast<double>(store.id()[i]);
      EXPECT_EQ(store.component(Field::position, 1)[i], id);
      if (i < fluid) {
        EXPECT_EQ(store.scalar(Field::mass)[i], id);
      }
    }
  }
}

}  // namespace
}  // namespace moraine
