// `moraine sweep`: many runs of one case, that go on after whatever stops them.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <thread>

#include "end_to_end/small_case.hpp"
#include "output/run_lock.hpp"
#include "support/help_examples.hpp"
#include "support/places.hpp"
#include "support/program.hpp"
#include "sweep/sweep_table.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

using State = SweepTable::State;

/// The process whose command line holds `words`, joined by blanks; 0 if there is none.
pid_t process_with(std::string const& words) {
  std::error_code none;
  for (auto const& entry : std::filesystem::directory_iterator("/proc", none)) {
    std::string const name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream stream(entry.path() / "cmdline", std::ios::binary);
    std::string line{std::istreambuf_iterator<char>(stream), {}};
    std::replace(line.begin(), line.end(), '\0', ' ');
    if (line.find(words) != std::string::npos) return static_cast<pid_t>(std::stol(name));
  }
  return 0;
}

/// Time steps of which the third is far too long.
constexpr char const* four_steps = R"(title = "time steps"
case = "case.toml"
method = "grid"
at_once = 2
[[parameter]]
key = "time.fixed_step"
values = ["0.1 ms", "0.2 ms", "5 ms", "0.3 ms"]
label = "step"
[[output]]
gauge = "foot"
column = "pressure"
measure = "largest"
[[output]]
gauge = "tip"
measure = "last"
)";

/// In place of the first [[output]]: long enough to be met while it runs.
constexpr char const* saves_often = R"([[parameter]]
keys = ["time.end", "output.checkpoints"]
values = [["0.2 s", "10 ms"]]
label = ["end", "saved"]
[[output]])";

class SweepCommand : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("case.toml"), small_case("end = 0.02"));
    write(path("steps.toml"), four_steps);
  }
  CommandResult sweep(std::vector<std::string> const& more = {}) const {
    std::vector<std::string> words{"sweep", "steps.toml", "-o", "results"};  // "out" is taken
    words.insert(words.end(), more.begin(), more.end());
    return moraine_command(path(""), words);
  }
  void replace_in_steps(std::string const& old, std::string const& now) const {
    std::string text = bytes_of(path("steps.toml"));
    replace(text, old, now);
    write(path("steps.toml"), text);
  }
  CommandResult sweep_to(std::string const& folder) const {
    return moraine_command(path(""), {"sweep", "steps.toml", "-o", folder});
  }
  SweepTable table(std::string const& folder = "results") const {
    return read_sweep_table(path(folder));
  }
  /// sweep.csv without the wall times, which differ from run to run.
  std::string timeless_csv(std::string const& folder) const {
    constexpr int before = 8;  // fields
    std::istringstream lines(bytes_of(path(folder + "/sweep.csv")));
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
      std::size_t at = 0;
      for (int i = 0; i < before; ++i) at = line.find(',', at) + 1;
      kept += line.substr(0, at) + line.substr(line.find(',', at)) + '\n';
    }
    return kept;
  }
  std::filesystem::file_time_type age(std::string const& file) const {
    return std::filesystem::last_write_time(path(file));
  }
  /// Until a run has saved a state that is whole: then its file has its name.
  void wait_for_checkpoint(std::string const& run) const {
    auto const saved = [&] {
      std::error_code none;
      for (auto const& entry :
           std::filesystem::directory_iterator(path(run + "/checkpoints"), none))
        if (entry.path().extension() == ".h5") return true;
      return false;
    };
    for (int tries = 0; tries < 30000 && !saved(); ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  static void replace(std::string& text, std::string const& old, std::string const& now) {
    auto const at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    text.replace(at, old.size(), now);
  }
};

TEST_F(SweepCommand, RunsAllMembersAndReportsTheOneThatFails) {
  CommandResult const result = sweep();
  EXPECT_EQ(result.code, 1) << result.err;
  SweepTable const results = table();
  ASSERT_EQ(results.members.size(), 4U);
  EXPECT_EQ(results.parameters[0].unit, "s");
  for (std::size_t i : {0U, 1U, 3U}) {
    EXPECT_EQ(results.members[i].state, State::done);
    EXPECT_NEAR(*results.members[i].outputs[0], 2115.0, 10.0) << "as moraine run";
    EXPECT_NEAR(*results.members[i].outputs[1], 0.1923, 0.001);
  }
  auto const& failed = results.members[2];
  EXPECT_EQ(failed.state, State::failed);
  EXPECT_FALSE(failed.outputs[0]);
  EXPECT_EQ(failed.message.substr(0, 9), "unstable:") << failed.message;
  EXPECT_NE(result.err.find("003-5_ms failed: unstable"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("2 running"), std::string::npos) << "two at a time";
  EXPECT_EQ(result.err.find("3 running"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(path("results/plots/sweep_step.png")));
}

TEST_F(SweepCommand, ItsPageTakesAnotherTitle) {
  replace_in_steps("\"0.1 ms\", \"0.2 ms\", \"5 ms\", ", "");
  ASSERT_EQ(sweep().code, 0);
  auto const title = [&] {
    std::string const page = bytes_of(path("results/sweep.html"));
    return page.substr(page.find("<title>"), 40);
  };
  EXPECT_NE(title().find("time steps"), std::string::npos) << title();
  ASSERT_EQ(moraine_command(path(""), {"report", "results", "--title", "mine"}).code, 0);
  EXPECT_NE(title().find("mine"), std::string::npos) << title();
}

TEST_F(SweepCommand, ASecondCallRunsNothing) {
  ASSERT_EQ(sweep().code, 1);
  std::string const first = bytes_of(path("results/sweep.csv"));
  auto const manifest = age("results/members/001-0.1_ms/manifest.json");
  auto const log = age("results/members/003-5_ms/log.txt");
  CommandResult const again = sweep();
  EXPECT_EQ(again.code, 1);
  EXPECT_NE(again.out.find("4 kept from before: nothing is left to run"), std::string::npos)
      << again.out;
  EXPECT_EQ(bytes_of(path("results/sweep.csv")), first);
  EXPECT_EQ(age("results/members/001-0.1_ms/manifest.json"), manifest);
  EXPECT_EQ(age("results/members/003-5_ms/log.txt"), log);

  CommandResult const forced = sweep({"--force"});
  EXPECT_EQ(forced.code, 1);
  EXPECT_NE(forced.out.find("3 kept from before"), std::string::npos) << forced.out;
  EXPECT_NE(age("results/members/003-5_ms/log.txt"), log) << "failed ones run again";
}

TEST_F(SweepCommand, ThreadsAreSharedOut) {
  ASSERT_EQ(sweep({"--threads", "3"}).code, 1);
  auto const threads = [&](std::string const& member) {
    std::string const manifest = bytes_of(path("results/members/" + member + "/manifest.json"));
    return manifest.substr(manifest.find("\"threads\": "), 12);
  };
  EXPECT_EQ(threads("001-0.1_ms"), "\"threads\": 2");
  EXPECT_EQ(threads("002-0.2_ms"), "\"threads\": 1");
}

TEST_F(SweepCommand, MemberCasesRunAlone) {
  ASSERT_EQ(sweep().code, 1);
  auto const run =
      moraine_command(path(""), {"run", "results/members/002-0.2_ms/case.toml", "-o", "alone"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(bytes_of(path("alone/gauges.csv")),
            bytes_of(path("results/members/002-0.2_ms/gauges.csv")));
}

TEST_F(SweepCommand, KilledInTheMiddleItGoesOnToTheSameTable) {
  std::string slow = four_steps;
  replace(slow, "[[output]]",
          "[[parameter]]\nkeys = [\"time.end\", \"output.checkpoints\"]\n"
          "values = [[\"0.15 s\", \"10 ms\"]]\nlabel = [\"end\", \"saved\"]\n[[output]]");
  replace(slow, "\"5 ms\"", "\"0.15 ms\"");
  write(path("steps.toml"), slow);
  ASSERT_EQ(sweep_to("whole").code, 0);

  std::filesystem::create_directories(path("live"));
  Program program(path("live"), {"sweep", "../steps.toml", "-o", "../broken"});
  wait_for_checkpoint("broken/members/001-0.1_ms");
  program.send(SIGKILL);
  ASSERT_EQ(program.wait().code, 128 + SIGKILL) << "it went on until now";
  CommandResult const resumed = sweep_to("broken");
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(timeless_csv("broken"), timeless_csv("whole"));
  EXPECT_EQ(bytes_of(path("broken/members/001-0.1_ms/gauges.csv")),
            bytes_of(path("whole/members/001-0.1_ms/gauges.csv")));
  EXPECT_NE(bytes_of(path("broken/members/001-0.1_ms/log.txt")).find("goes on at time"),
            std::string::npos)
      << "from its checkpoint";
}

TEST_F(SweepCommand, AMemberThatIsKilledGoesOn) {
  std::string one = four_steps;
  replace(one, "\"0.2 ms\", \"5 ms\", \"0.3 ms\"", "\"0.2 ms\"");
  replace(one, "[[output]]", saves_often);
  write(path("steps.toml"), one);
  std::filesystem::create_directories(path("live"));
  std::string const folder = path("killed").string();
  Program program(path("live"), {"sweep", "../steps.toml", "-o", folder});
  wait_for_checkpoint("killed/members/001-0.1_ms");
  pid_t const member = process_with("moraine run " + folder + "/members/001");
  ASSERT_NE(member, 0);
  ASSERT_EQ(kill(member, SIGKILL), 0);
  CommandResult const result = program.wait();
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(bytes_of(path("killed/members/001-0.1_ms/log.txt")).find("goes on at time"),
            std::string::npos);
}

TEST_F(SweepCommand, AMemberThatIsKilledWhileItWritesItsPageIsDone) {
  replace_in_steps("\"0.2 ms\", \"5 ms\", \"0.3 ms\"", "\"0.2 ms\"");
  replace_in_steps("[[output]]", saves_often);
  std::filesystem::create_directories(path("live"));
  std::string const folder = path("killed").string(), run = "killed/members/001-0.1_ms";
  Program program(path("live"), {"sweep", "../steps.toml", "-o", folder});
  wait_for_checkpoint(run);
  pid_t const member = process_with("moraine run " + folder + "/members/001");
  ASSERT_NE(member, 0);
  // The page looks for this file, and reads from a pipe until there is somebody who writes.
  ASSERT_EQ(mkfifo(path(run + "/walls.pvd").c_str(), 0600), 0);
  auto const ended = [&] {
    return bytes_of(path(run + "/manifest.json")).find("end time reached") != std::string::npos;
  };
  for (int tries = 0; tries < 30000 && !ended(); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::filesystem::remove(path(run + "/walls.pvd"));
  ASSERT_EQ(kill(member, SIGKILL), 0);
  CommandResult const result = program.wait();
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_FALSE(std::filesystem::exists(path(run + "/report.html"))) << "it was not killed";
  std::string const log = bytes_of(path(run + "/log.txt"));
  EXPECT_EQ(log.find("small dam"), log.rfind("small dam")) << "ran again: " << log;
}

TEST_F(SweepCommand, PagesThatCannotBeWrittenAreWarnings) {
  replace_in_steps("\"5 ms\", ", "");
  constexpr rlim_t less_than_a_page = 500'000;  // bytes; the player of particles alone has more
  CommandResult const result =
      Program(path(""), {"sweep", "steps.toml", "-o", "results"}, less_than_a_page).wait();
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("warning: results/sweep.html could not be written"), std::string::npos)
      << result.err;
  EXPECT_EQ(result.out.find("sweep.html"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("sweep_step.png"), std::string::npos) << result.out;
  EXPECT_FALSE(std::filesystem::exists(path("results/sweep.html")));
}

TEST_F(SweepCommand, CtrlCSavesTheMembersThatRun) {
  std::string endless = four_steps;
  replace(endless, "[[output]]",
          "[[parameter]]\nkey = \"time.end\"\nvalues = [1000.0]\n[[output]]");
  write(path("steps.toml"), endless);
  std::filesystem::create_directories(path("live"));
  Program program(path("live"), {"sweep", "../steps.toml", "-o", "../stopped"});
  wait_for_checkpoint("stopped/members/001-0.1_ms");
  wait_for_checkpoint("stopped/members/002-0.2_ms");
  program.send(SIGINT);
  CommandResult const stopped = program.wait();
  EXPECT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_NE(stopped.out.find("stopped; the same command goes on"), std::string::npos);
  for (std::string const name : {"001-0.1_ms", "002-0.2_ms"}) {
    EXPECT_FALSE(RunLock::is_held(path("stopped/members/" + name))) << "no process is left";
    EXPECT_NE(bytes_of(path("stopped/members/" + name + "/manifest.json")).find("interrupted"),
              std::string::npos);
  }
  for (auto const& member : table("stopped").members) EXPECT_EQ(member.state, State::waiting);
}

TEST_F(SweepCommand, AChangedSweepKeepsWhatIsTheSame) {
  ASSERT_EQ(sweep().code, 1);
  std::string more = four_steps;
  replace(more, "\"0.1 ms\", ", "\"0.05 ms\", \"0.1 ms\", ");
  replace(more, "\"5 ms\", ", "");
  write(path("steps.toml"), more);
  CommandResult const result = sweep();
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("001-0.1_ms is now 002-0.1_ms"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("3 kept from before"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("members/003-5_ms belongs to no member"), std::string::npos);
  EXPECT_EQ(table().members.size(), 4U);
}

TEST_F(SweepCommand, AChangedCaseIsNotOverwrittenUnasked) {
  ASSERT_EQ(sweep().code, 1);
  std::string const before = bytes_of(path("results/sweep.csv"));
  write(path("case.toml"), small_case("end = 0.01"));
  CommandResult const refused = sweep();
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("001-0.1_ms: has changed: \"results/members/001-0.1_ms\" holds the "
                             "results of another case; --force replaces them"),
            std::string::npos)
      << refused.err;
  EXPECT_EQ(bytes_of(path("results/sweep.csv")), before);
  EXPECT_EQ(sweep({"--force"}).code, 0) << "so short that even the long steps hold";
  EXPECT_NE(bytes_of(path("results/sweep.csv")), before);
}

TEST_F(SweepCommand, MistakesStopItBeforeAnythingIsWritten) {
  std::string wrong = four_steps;
  replace(wrong, "\"0.2 ms\"", "\"0.2 mm\"");
  replace(wrong, "\"foot\"", "\"fot\"");
  write(path("steps.toml"), wrong);
  CommandResult const result = sweep();
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "steps.toml:7:21: time.fixed_step: \"0.2 mm\" is a length; a time is expected (s)\n"
            "steps.toml:10:9: output[1].gauge: \"fot\" is no gauge of the case; did you mean "
            "\"foot\"?\n");
  EXPECT_FALSE(std::filesystem::exists(path("results")));
}

TEST_F(SweepCommand, ListSaysWhatWouldRunAndWritesNothing) {
  CommandResult const result = sweep({"--list"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("002-0.2_ms: to run\n  time.fixed_step = \"0.2 ms\"\n"),
            std::string::npos)
      << result.out;
  EXPECT_FALSE(std::filesystem::exists(path("results")));
}

TEST_F(SweepCommand, TheExampleOfThePageIsGood) {
  std::string const page = bytes_of(source_folder() + "/docs/sweeps.md");
  auto const begin = page.find("```toml\n") + 8;
  std::filesystem::create_directories(path("sweeps"));
  write(path("sweeps/page.toml"), page.substr(begin, page.find("```", begin) - begin));
  std::filesystem::copy_file(source_folder() + "/cases/tnt-in-water/case.toml", path("case.toml"),
                             std::filesystem::copy_options::overwrite_existing);
  auto const result = moraine_command(path(""), {"sweep", "sweeps/page.toml", "--list"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("\n6 members\n"), std::string::npos) << result.out;
}

// The sweeps that come with the program, and the examples of the help.
TEST_F(SweepCommand, ShippedSweepsAreGood) {
  std::filesystem::create_directory_symlink(source_folder() + "/cases", path("cases"));
  auto const help = moraine_command(path(""), {"sweep", "--help"});
  auto const examples = commands_in(help.out, "  ");
  EXPECT_GE(examples.size(), 3U);
  std::set<std::string> files;
  for (auto const& example : examples) files.insert(words_of_command(example).at(1));
  for (auto const& entry : std::filesystem::directory_iterator(path("cases/tnt-in-water/sweeps")))
    files.insert("cases/tnt-in-water/sweeps/" + entry.path().filename().string());
  EXPECT_EQ(files.size(), 3U);
  for (auto const& file : files) {
    auto const result = moraine_command(path(""), {"sweep", file, "--list"});
    EXPECT_EQ(result.code, 0) << result.err;
  }
}

}  // namespace
}  // namespace moraine
