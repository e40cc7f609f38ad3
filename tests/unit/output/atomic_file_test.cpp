#include "output/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class AtomicFiles : public ScratchFolder {
 protected:
  /// Files and folders right in the scratch folder.
  auto files() const { return std::distance(std::filesystem::directory_iterator(path("")), {}); }

  /// A process that leaves half a file, and is gone; or that also writes the other half.
  void in_another_process(bool commit) const {
    pid_t const child = fork();
    if (child == 0) {
      auto* const file = new AtomicFile(path("file"));  // never removed
      file->stream() << "other\n" << std::flush;
      if (commit) file->commit();
      _exit(0);
    }
    waitpid(child, nullptr, 0);
  }
};

TEST_F(AtomicFiles, OfTwoProcessesDoNotMix) {
  AtomicFile file(path("file"));
  file.stream() << "mine, " << std::flush;
  in_another_process(true);
  EXPECT_EQ(bytes_of(path("file")), "other\n");
  file.stream() << "and whole\n";
  file.commit();
  EXPECT_EQ(bytes_of(path("file")), "mine, and whole\n");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFiles, OfProcessesThatAreGoneAreRemoved) {
  in_another_process(false);
  std::filesystem::create_directories(path("frames"));
  write(path("frames/half.999999999.tmp"), "");  // more than Linux counts to
  write(path("mine.tmp"), "");
  AtomicFile file(path("file"));
  remove_temporaries(path(""));
  EXPECT_TRUE(std::filesystem::is_empty(path("frames")));
  EXPECT_EQ(files(), 3) << "the folder, what is no file of ours, and what is being written";
  file.commit();
  EXPECT_TRUE(std::filesystem::exists(path("file")));
}

}  // namespace
}  // namespace moraine
