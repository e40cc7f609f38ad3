#include "report/shown_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moraine::report {
namespace {

TEST(Selection, ShowsEverythingThatFits) {
  Selection const s = select(100, 1000, 20, 10'000'000, 50'000);
  EXPECT_EQ(s.frames, 100u);
  EXPECT_EQ(s.share, 1.0);
}

TEST(Selection, LeavesOutFramesBeforeParticles) {
  Selection const s = select(200, 10'000, 20, 10'000'000, 50'000);
  EXPECT_EQ(s.frames, 50u) << "10 MB are 500 000 places of 20 bytes";
  EXPECT_EQ(s.share, 1.0);
}

TEST(Selection, KeepsTwentyFramesOfManyParticles) {
  Selection const s = select(200, 1'000'000, 20, 10'000'000, 50'000);
  EXPECT_EQ(s.frames, 20u);
  EXPECT_NEAR(s.share, 0.025, 1e-12) << "25 000 in each";
  EXPECT_LE(static_cast<double>(s.frames) * s.share * 1e6 * 20, 10'000'000.0 * (1 + 1e-9));
}

TEST(Selection, ShowsNoMoreThanABrowserDraws) {
  Selection const s = select(2, 1'000'000, 20, 100'000'000, 50'000);
  EXPECT_EQ(s.frames, 2u);
  EXPECT_NEAR(s.share, 0.05, 1e-12);
}

TEST(Share, HoldsItsPartOfTheIdsWithoutAPattern) {
  constexpr std::uint64_t ids = 100'000;
  int odd = 0, all = 0;
  for (std::uint64_t id = 0; id < ids; ++id)
    if (is_in_share(id, 0.1)) {
      ++all;
      odd += id % 2 == 1 ? 1 : 0;
    }
  // Four standard deviations of a binomial distribution.
  EXPECT_NEAR(all, 10'000, 4 * std::sqrt(100'000 * 0.1 * 0.9));
  EXPECT_NEAR(odd, all / 2.0, 4 * std::sqrt(all * 0.25));
}

// What a smaller share shows, a larger one shows too.
TEST(Share, GrowsByAddingParticles) {
  for (std::uint64_t id = 0; id < 10'000; ++id) {
    EXPECT_TRUE(is_in_share(id, 1.0));
    EXPECT_TRUE(!is_in_share(id, 0.2) || is_in_share(id, 0.3)) << id;
  }
}

}  // namespace
}  // namespace moraine::report
