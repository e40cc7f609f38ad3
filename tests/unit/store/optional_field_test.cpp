// Fields that only some runs have.
#include <gtest/gtest.h>

#include <vector>

#include "store/particle_store.hpp"
#include "support/memory_archive.hpp"

namespace moraine {
namespace {

std::vector<double> values(ParticleStore const& store) {
  auto const span = store.scalar(Field::burn_fraction);
  return {span.begin(), span.end()};
}

/// Three fluid particles, of which the last came after the field, and a wall particle.
ParticleStore burning() {
  ParticleStore store(2);
  store.append(Kind::fluid, 0);
  store.append(Kind::fluid, 0);
  store.use(Field::burn_fraction);
  store.append(Kind::fluid, 1);
  store.append(Kind::wall, no_material);
  store.scalar(Field::burn_fraction)[1] = 0.5;
  store.scalar(Field::burn_fraction)[2] = 1.0;
  return store;
}

TEST(OptionalField, IsThereWhenAskedFor) {
  ParticleStore plain(2);
  plain.append(Kind::fluid, 0);
  EXPECT_FALSE(plain.has(Field::burn_fraction));
  EXPECT_TRUE(plain.has(Field::density));
  EXPECT_TRUE(plain.scalar(Field::burn_fraction).empty());
  ParticleStore const store = burning();
  EXPECT_TRUE(store.has(Field::burn_fraction));
  EXPECT_FALSE(store.has(Field::lighting_time));
  EXPECT_EQ(values(store), (std::vector<double>{0.0, 0.5, 1.0})) << "walls have none";
}

TEST(OptionalField, MovesWithItsParticles) {
  ParticleStore store = burning();
  store.permute(Kind::fluid, std::vector<std::uint32_t>{2, 0, 1});
  EXPECT_EQ(values(store), (std::vector<double>{1.0, 0.0, 0.5}));
  store.remove(std::vector<std::uint32_t>{0});
  EXPECT_EQ(values(store), (std::vector<double>{0.0, 0.5}));
  store.use(Field::burn_fraction);
  EXPECT_EQ(values(store), (std::vector<double>{0.0, 0.5})) << "asking twice changes nothing";
}

TEST(OptionalField, IsSavedAndRestored) {
  MemoryArchive archive;
  ParticleStore store = burning();
  store.exchange(archive);
  archive.restore();
  ParticleStore restored(2);
  restored.exchange(archive);
  EXPECT_TRUE(restored.has(Field::burn_fraction));
  EXPECT_EQ(values(restored), values(store));

  MemoryArchive without;
  ParticleStore plain(2);
  plain.append(Kind::fluid, 0);
  plain.exchange(without);
  without.restore();
  restored.exchange(without);
  EXPECT_FALSE(restored.has(Field::burn_fraction)) << "what was not saved is not there";
  EXPECT_TRUE(values(restored).empty());
}

}  // namespace
}  // namespace moraine
