// How the program itself ends on bad input, on signals and on failures while it runs.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

struct Ending {
  int code = 0;  // 128 + signal where a signal ended it
  std::string text;
};

class Program : public ScratchFolder {
 protected:
  /// Runs `moraine ARGUMENTS` in the scratch folder, by way of a shell.
  Ending moraine(std::string const& arguments, std::string const& before = "") const {
    auto const program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "moraine";
    EXPECT_TRUE(std::filesystem::exists(program)) << program;
    std::string const command = "cd '" + path("").string() + "' && " + before + " '" +
                                program.string() + "' " + arguments + " > log 2>&1";
    int const status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            bytes_of(path("log"))};
  }

  void write_case(std::string const& name, std::string const& end, std::string const& more = "") {
    write(path(name), "[space]\ndimension = 1\n[resolution]\nspacing = 0.01\n[time]\nend = " + end +
                          "\n" + more +
                          "[material.water]\neos = \"tait\"\n[[region]]\nname = \"pool\"\n"
                          "material = \"water\"\nbox = { min = [0], max = [1] }\n");
  }
};

TEST_F(Program, NamesTheNearestCommand) {
  Ending const ending = moraine("rum x.toml");
  EXPECT_EQ(ending.code, 2);
  EXPECT_EQ(ending.text, "moraine: \"rum\" is not a command; did you mean \"run\"?\n");
  EXPECT_EQ(moraine("--version").code, 0);
}

TEST_F(Program, RefusesFoldersThatAreNoRuns) {
  write(path("file"), "");
  std::filesystem::create_directories(path("empty"));
  EXPECT_EQ(moraine("plot none").text,
            "moraine plot: folder: \"none\" is no run folder: it does not exist; give the folder "
            "that \"moraine run\" has written\n");
  for (char const* folder : {"none", "file", "empty"})
    EXPECT_EQ(moraine(std::string("plot ") + folder).code, 2) << folder;
}

TEST_F(Program, RefusesCaseFilesThatCannotBeRead) {
  std::filesystem::create_directories(path("folder"));
  EXPECT_EQ(moraine("run none.toml").text, "none.toml: does not exist\n");
  EXPECT_EQ(moraine("run folder").text, "folder: is a folder, not a case file\n");
  write(path("folder/case.toml"), "");
  EXPECT_EQ(moraine("run folder").text,
            "folder: is a folder, not a case file; did you mean \"folder/case.toml\"?\n");
  for (char const* name : {"none.toml", "folder"})
    EXPECT_EQ(moraine(std::string("run ") + name).code, 2) << name;
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(Program, RefusesAFileAsFolderForResults) {
  write_case("a.toml", "1e-6");
  write(path("taken"), "mine");
  for (std::string const output : {"taken", "taken/below"}) {
    Ending const ending = moraine("run a.toml -o " + output);
    EXPECT_EQ(ending.code, 2);
    EXPECT_NE(ending.text.find("moraine run: --output: \"" + output + "\" cannot be a folder"),
              std::string::npos)
        << ending.text;
  }
  EXPECT_EQ(bytes_of(path("taken")), "mine");
}

TEST_F(Program, NamesResultsAfterTheCase) {
  std::filesystem::create_directories(path("tank"));
  write_case("tank/case.toml", "1e-6");
  write_case("tank/other.toml", "1e-6");
  EXPECT_EQ(moraine("run tank/case.toml").code, 0);
  EXPECT_EQ(moraine("run tank/other.toml").code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("out/tank/sums.csv")));
  EXPECT_TRUE(std::filesystem::exists(path("out/other/sums.csv")));
}

TEST_F(Program, WritesWhatItHasWhenTheRunBreaksDown) {
  // 1 m/s for a second at a fixed step of 0.1 s: ten smoothing lengths in a step.
  write_case("a.toml", "1", "fixed_step = 0.1\n");
  write(path("a.toml"), bytes_of(path("a.toml")) + "velocity = [1]\n");
  Ending const ending = moraine("run a.toml -o out");
  EXPECT_EQ(ending.code, 3) << ending.text;
  EXPECT_NE(ending.text.find("farther than the smoothing length"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(path("out/bad/frame.vtp")));
  EXPECT_NE(bytes_of(path("out/manifest.json")).find("farther than"), std::string::npos);
}

TEST_F(Program, SaysWhatElseEndedARun) {
  // Files may not grow beyond 200 blocks of 512 bytes: as on a full disk, sums.csv cannot be
  // written any more; checkpoints and frames of 100 particles can.
  write_case("a.toml", "1");
  Ending const ending = moraine("run a.toml -o out", "trap '' XFSZ; ulimit -f 200;");
  EXPECT_EQ(ending.code, 4) << ending.text;
  EXPECT_NE(ending.text.find("the run stopped at time"), std::string::npos) << ending.text;
  EXPECT_NE(ending.text.find("sums.csv"), std::string::npos) << ending.text;
  EXPECT_NE(bytes_of(path("out/manifest.json")).find("the run stopped at time"), std::string::npos);
}

TEST_F(Program, APageThatCannotBeWrittenIsAWarning) {
  // As above, but so short that only the page is too large.
  write_case("a.toml", "1e-6");
  Ending const ending = moraine("run a.toml -o out", "trap '' XFSZ; ulimit -f 200;");
  EXPECT_EQ(ending.code, 0) << ending.text;
  EXPECT_NE(ending.text.find("warning: out/report.html could not be written"), std::string::npos)
      << ending.text;
  EXPECT_NE(ending.text.find("results in out: particles.pvd"), std::string::npos) << ending.text;
  EXPECT_FALSE(std::filesystem::exists(path("out/report.html")));
  EXPECT_NE(bytes_of(path("out/manifest.json")).find("end time reached"), std::string::npos);
}

class Interrupted : public Program {
 protected:
  /// Starts a run without end and waits until it steps.
  pid_t start() {
    write_case("long.toml", "1e9");
    std::string const program =
        (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "moraine").string();
    std::string const case_file = path("long.toml").string(), out = path("out").string();
    std::fflush(nullptr);  // or both would print what is buffered
    pid_t const child = fork();
    if (child == 0) {
      std::signal(SIGINT, SIG_DFL);
      if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(120);
      if (std::freopen(path("stderr").c_str(), "w", stderr) == nullptr) _exit(121);
      execl(program.c_str(), "moraine", "run", case_file.c_str(), "-o", out.c_str(), nullptr);
      _exit(122);
    }
    auto const rows = [&] {
      std::string const sums = bytes_of(path("out/sums.csv"));
      return std::count(sums.begin(), sums.end(), '\n');
    };
    for (int k = 0; k < 3000 && rows() < 4; ++k) usleep(10000);
    return child;
  }

  /// Puts a folder with something in it where a run writes a file: neither open nor rename can.
  void block(std::string const& file) const {
    std::filesystem::create_directories(path(file + ".block/inside"));
    std::error_code again;  // the run may have written the file once more
    do {
      std::filesystem::remove(path(file));
      std::filesystem::rename(path(file + ".block"), path(file), again);
    } while (again);
  }

  /// Waits until the run has written these words to stderr.
  bool said(std::string const& words) const {
    for (int k = 0; k < 1000; ++k, usleep(10000))
      if (bytes_of(path("stderr")).find(words) != std::string::npos) return true;
    return false;
  }
};

TEST_F(Interrupted, OnceEndsCleanly) {
  pid_t const child = start();
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_NE(bytes_of(path("out/manifest.json")).find("interrupted"), std::string::npos);
}

TEST_F(Interrupted, OutlivesAStatusAndASnapshotThatCannotBeWritten) {
  pid_t const child = start();
  block("out/status.json");
  block("out/report.html");
  write(path("out/snapshots"), "");  // no folder for snapshots
  write(path("out/snapshot"), "");
  EXPECT_TRUE(said("warning: the status is not up to date")) << bytes_of(path("stderr"));
  EXPECT_TRUE(said("the snapshot is not there")) << bytes_of(path("stderr"));
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  std::string const words = bytes_of(path("stderr"));
  EXPECT_EQ(words.find("the status"), words.rfind("the status")) << "once: " << words;
  std::string const manifest = bytes_of(path("out/manifest.json"));
  EXPECT_NE(manifest.find("interrupted"), std::string::npos) << manifest;
  EXPECT_EQ(manifest.find("the run stopped"), std::string::npos) << manifest;
}

TEST_F(Interrupted, TwiceEndsAtOnce) {
  pid_t const child = start();
  auto const pipe = path("out/manifest.json." + std::to_string(child) + ".tmp");
  // Nobody reads this pipe: the clean end waits there for ever.
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  int status = 0;
  for (int k = 0; k < 500 && waitpid(child, &status, WNOHANG) == 0; ++k) {
    kill(child, k < 499 ? SIGINT : SIGKILL);  // early ones may arrive together as one
    usleep(20000);
  }
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGINT);  // a shell calls this 130
  EXPECT_NE(bytes_of(path("out/manifest.json")).find("running"), std::string::npos);
}

}  // namespace
}  // namespace moraine
