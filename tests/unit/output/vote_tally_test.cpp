#include "output/vote_tally.hpp"

#include <gtest/gtest.h>

#include "support/memory_archive.hpp"

namespace moraine {
namespace {

TEST(VoteTally, CountsWhoLimitedTheSteps) {
  VoteTally tally;
  EXPECT_TRUE(tally.shares().empty());
  for (double const step : {3.0, 1.0, 2.0}) tally.note({step, motion_limit, 4});
  tally.note({0.5, sound_limit, 1});
  tally.note({9.0, "something else", 1});
  auto const shares = tally.shares();
  ASSERT_EQ(shares.size(), 3u);
  EXPECT_EQ(shares[0].reason, motion_limit);
  EXPECT_EQ(shares[0].steps, 3u);
  EXPECT_EQ(shares[0].least_time_step, 1.0);
  EXPECT_EQ(shares[2].reason, "nothing");
}

TEST(VoteTally, GoesOnFromACheckpoint) {
  VoteTally tally;
  tally.note({0.5, sound_limit, 1});
  tally.note({0.25, end_of_run, 1});
  MemoryArchive archive;
  tally.exchange(archive);
  archive.restore();
  VoteTally other;
  other.exchange(archive);
  other.note({0.125, sound_limit, 1});
  ASSERT_EQ(other.shares().size(), 2u);
  EXPECT_EQ(other.shares()[0].steps, 2u);
  EXPECT_EQ(other.shares()[0].least_time_step, 0.125);
}

}  // namespace
}  // namespace moraine
