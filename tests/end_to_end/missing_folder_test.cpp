#include <gtest/gtest.h>

#include <filesystem>

#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class MissingFolder : public ScratchFolder {};

// A test whose folder is gone must not write to wherever the tests were started.
TEST_F(MissingFolder, LeavesNoFilesElsewhere) {
  auto const before = std::filesystem::current_path();
  std::filesystem::create_directories(path("here"));
  std::filesystem::current_path(path("here"));
  CommandResult const result = moraine_command("gone", {"--version"});
  bool const is_clean = std::filesystem::is_empty(".");
  std::filesystem::current_path(before);
  EXPECT_EQ(result.code, 127);
  EXPECT_TRUE(is_clean);
}

}  // namespace
}  // namespace moraine
