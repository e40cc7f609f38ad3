#include "output/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace moraine {
namespace {

struct FakeRun {
  std::ostringstream text;
  double clock = 100.0;

  ProgressSink sink(bool terminal, std::size_t columns = 200) {
    return {&text, [this] { return clock; }, terminal, columns};
  }
  std::string take() {
    std::string taken = text.str();
    text.str("");
    return taken;
  }
};

ProgressReport report(int step, int steps) {
  return {static_cast<double>(step) * 1e-3,
          static_cast<double>(steps) * 1e-3,
          static_cast<std::uint64_t>(step),
          1e-3,
          "sound speed",
          2000000};
}

TEST(Progress, LogGetsALineAtEachTenth) {
  FakeRun run;
  Progress progress(run.sink(false));
  for (int step = 0; step <= 1000; ++step) {
    progress.update(report(step, 1000));
    run.clock += 0.01;
  }
  progress.finish();
  std::string const text = run.take();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_NE(text.find(" 10 %  t = 100.0 ms  step 100"), std::string::npos) << text;
  EXPECT_NE(text.find("100 %"), std::string::npos) << text;
}

TEST(Progress, LogGetsALineEveryFiveSecondsOfASlowRun) {
  FakeRun run;
  Progress progress(run.sink(false));
  for (int step = 0; step <= 60; ++step) {
    progress.update(report(step, 1000000));
    run.clock += 0.5;
  }
  // Thirty seconds: lines at 5, 10, ... 30 s.
  std::string const text = run.take();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6) << text;
  progress.finish();
}

TEST(Progress, ShowsRatesTimeLeftAndWhoLimitsTheStep) {
  FakeRun run;
  Progress progress(run.sink(false));
  // Five steps per second of 2 million particles; 1000 steps take 200 s, 100 of them are done.
  for (int step = 0; step <= 100; ++step) {
    progress.update(report(step, 1000));
    run.clock += 0.2;
  }
  std::string const text = run.take();
  std::string const last = text.substr(text.rfind("10 %"));
  EXPECT_NE(last.find("5.00 steps/s"), std::string::npos) << last;
  EXPECT_NE(last.find("10.0 M updates/s"), std::string::npos) << last;
  EXPECT_NE(last.find("ETA 3:00"), std::string::npos) << last;
  EXPECT_NE(last.find("Δt = 1.00 ms (sound speed)"), std::string::npos) << last;
  progress.finish();
}

TEST(Progress, TerminalIsRedrawnTenTimesASecondAndRestored) {
  FakeRun run;
  Progress progress(run.sink(true));
  for (int step = 0; step <= 1000; ++step) {
    progress.update(report(step, 10000));
    run.clock += 0.001;
  }
  std::string const text = run.take();
  auto const drawn = std::count(text.begin(), text.end(), '\r');
  EXPECT_GE(drawn, 9);
  EXPECT_LE(drawn, 10);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  progress.finish();
  std::string const end = run.take();
  EXPECT_EQ(end.back(), '\n');
  EXPECT_EQ(std::count(end.begin(), end.end(), '\n'), 1);
  progress.update(report(2000, 10000));
  EXPECT_EQ(run.take(), "");
}

TEST(Progress, NeverWrapsANarrowTerminal) {
  FakeRun run;
  Progress progress(run.sink(true, 30));
  progress.update(report(0, 10));
  run.clock += 1.0;
  progress.update(report(5, 10));
  std::string const text = run.take();
  std::string const line = text.substr(text.rfind("\x1b[2K") + 4);
  auto const characters = std::count_if(line.begin(), line.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  EXPECT_EQ(characters, 29);
}

TEST(Progress, ClearRemovesTheBar) {
  FakeRun run;
  Progress progress(run.sink(true));
  progress.update(report(0, 10));
  progress.clear();
  EXPECT_EQ(run.take(), "");
  run.clock += 1.0;
  progress.update(report(5, 10));
  run.take();
  progress.clear();
  EXPECT_EQ(run.take(), "\r\x1b[2K");
}

TEST(Progress, CountsTheWayFromTheFirstReport) {
  FakeRun run;
  Progress progress(run.sink(false));
  progress.update(report(500, 1000));
  run.clock += 6.0;
  progress.update(report(750, 1000));
  EXPECT_NE(run.take().find(" 50 %"), std::string::npos);
}

TEST(Progress, DurationsAreRoundedUp) {
  EXPECT_EQ(duration(0.0), "0:00");
  EXPECT_EQ(duration(64.2), "1:05");
  EXPECT_EQ(duration(7800.0), "2:10:00");
  EXPECT_EQ(duration(76.0 * 3600.0), "3 d 4 h");
  EXPECT_EQ(duration(std::numeric_limits<double>::infinity()), "-");
}

}  // namespace
}  // namespace moraine
