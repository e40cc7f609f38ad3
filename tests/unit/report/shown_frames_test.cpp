#include "report/shown_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "output/run_folder.hpp"
#include "output/vtp_writer.hpp"
#include "unit/output/scratch_folder.hpp"

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

/// The file with other ids, as numbers with a fraction.
std::string with_ids(std::string vtp, std::vector<double> const& ids) {
  std::string const was = "type=\"UInt64\" Name=\"id\"";
  auto const at = vtp.find(was);
  EXPECT_NE(at, std::string::npos);
  vtp.replace(at, was.size(), "type=\"Float64\" Name=\"id\"");
  auto const offset = std::stoull(vtp.substr(vtp.find("offset=\"", at) + 8));
  auto const data = vtp.find('_', vtp.find('>', vtp.find("<AppendedData"))) + 1;
  std::memcpy(vtp.data() + data + offset + sizeof(std::uint64_t), ids.data(),
              ids.size() * sizeof(double));
  return vtp;
}

class ShownFiles : public ScratchFolder {
 protected:
  /// `frames` frames of `particles` particles whose ids are their numbers.
  RunFiles run(std::size_t frames, std::size_t particles) const {
    ParticleStore store(2);
    for (std::size_t i = 0; i < particles; ++i) {
      std::size_t const p = store.append(Kind::fluid, 0);
      store.component(Field::position, 0)[p] = static_cast<double>(i);
    }
    RunFiles files;
    files.folder = path("");
    for (std::size_t n = 0; n < frames; ++n) {
      files.frames.push_back({static_cast<double>(n), frame_name(n)});
      write_vtp(path(frame_name(n)), store, Kind::fluid, static_cast<double>(n));
    }
    return files;
  }
};

// What is read once can be thinned further without its files, to what a smaller budget reads.
TEST_F(ShownFiles, AreThinnedInMemory) {
  RunFiles const files = run(40, 1000);
  ShownFrames const all = read_shown_frames(files, {});
  ASSERT_EQ(all.frames.size(), 40u);
  ASSERT_EQ(all.frames[0].ids.size(), 1000u);
  ParticleBudget const small{.bytes = 200'000};
  ShownFrames const read = read_shown_frames(files, small);
  std::filesystem::remove_all(path("frames"));
  ShownFrames const part = thinned(all, small);
  ASSERT_LT(part.frames[0].ids.size(), 1000u);
  EXPECT_EQ(part.numbers, read.numbers);
  ASSERT_EQ(part.frames.size(), read.frames.size());
  for (std::size_t n = 0; n < part.frames.size(); ++n) {
    EXPECT_EQ(part.frames[n].time, read.frames[n].time);
    EXPECT_EQ(part.frames[n].ids, read.frames[n].ids);
    EXPECT_EQ(part.frames[n].places, read.frames[n].places);
    EXPECT_EQ(part.frames[n].values, read.frames[n].values);
  }
}

TEST_F(ShownFiles, LeaveOutParticlesWithoutAnId) {
  RunFiles const files = run(1, 3);
  auto const file = path(frame_name(0));
  ASSERT_EQ(read_shown_frames(files, {}).frames[0].ids.size(), 3u);
  write(file, with_ids(bytes_of(file), {std::nan(""), -4.0, 2.0}));
  EXPECT_EQ(read_shown_frames(files, {}).frames[0].ids, (std::vector<std::uint32_t>{2}));
}

}  // namespace
}  // namespace moraine::report
