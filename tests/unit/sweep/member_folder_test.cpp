#include "sweep/member_folder.hpp"

#include <gtest/gtest.h>

#include "output/sha256.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class MemberFolders : public ScratchFolder {
 protected:
  MemberFolder member(std::string const& text = "title = \"a\"\n") const {
    return {"001-a", path("001-a"), text};
  }
  /// As a run of this case leaves it; no reason: as a killed run does.
  void leave(MemberFolder const& member, std::string const& reason) const {
    prepare(member);
    std::string const end =
        reason.empty() ? "" : ", \"end\": {\"reason\": \"" + reason + "\", \"steps\": 3}";
    write(member.folder / "manifest.json",
          "{\"case_sha256\": \"" + sha256(member.case_text) + "\"" + end + "}");
  }
};

TEST_F(MemberFolders, TellWhatHasBecomeOfTheirRuns) {
  EXPECT_EQ(status_of(member()).state, MemberState::none);
  leave(member(), "");
  EXPECT_EQ(status_of(member()).state, MemberState::unfinished);
  leave(member(), "interrupted");
  EXPECT_EQ(status_of(member()).state, MemberState::unfinished);
  leave(member(), "end time reached");
  EXPECT_EQ(status_of(member()).state, MemberState::done);
  EXPECT_FALSE(can_resume(member()));
}

TEST_F(MemberFolders, TellThatTheirCaseHasChanged) {
  leave(member(), "end time reached");
  EXPECT_EQ(status_of(member("title = \"b\"\n")).state, MemberState::changed);
  // Killed after the new case was written, before the old results were cleared away.
  prepare(member("title = \"b\"\n"));
  EXPECT_EQ(status_of(member("title = \"b\"\n")).state, MemberState::none);
}

TEST_F(MemberFolders, RememberFailuresUntilTheyRunAgain) {
  leave(member(), "unstable: particle 3");
  EXPECT_EQ(reason_of_failure(member(), 0), "unstable: particle 3");
  EXPECT_EQ(status_of(member()).state, MemberState::unfinished) << "the disk may have been full";
  note_failure(member(), 3, "unstable: particle 3");
  EXPECT_EQ(status_of(member()).state, MemberState::failed);
  EXPECT_EQ(status_of(member()).message, "unstable: particle 3");
  EXPECT_EQ(status_of(member("title = \"b\"\n")).state, MemberState::changed);
  prepare(member());
  EXPECT_NE(status_of(member()).state, MemberState::failed);
}

TEST_F(MemberFolders, FindReasonsInTheLogOfTheLastTry) {
  prepare(member());
  write(log_of(member()), "first try\nbad luck\n");
  EXPECT_EQ(reason_of_failure(member(), 0), "bad luck");
  EXPECT_EQ(reason_of_failure(member(), 19), "");
}

TEST_F(MemberFolders, DamagedFilesAreNoResults) {
  leave(member(), "end time reached");
  write(path("001-a/manifest.json"), "{\"case_sha");
  EXPECT_EQ(status_of(member()).state, MemberState::none);
}

}  // namespace
}  // namespace moraine
