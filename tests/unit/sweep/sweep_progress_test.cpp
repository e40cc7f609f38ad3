#include "sweep/sweep_progress.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace moraine {
namespace {

TEST(SweepProgressLine, ComesWithEachChangeAndEstimatesTheRest) {
  std::ostringstream text;
  double now = 0.0;
  SweepProgress progress({&text, [&] { return now; }, false, 80});
  progress.update({5, 0, 0, {0.0, 0.0}, 2});
  progress.update({5, 0, 0, {1.0, 1.0}, 2});  // nothing new
  progress.learn(10.0);
  progress.update({5, 1, 0, {10.0, 0.0}, 2});
  progress.learn(30.0);
  progress.update({5, 1, 1, {15.0}, 2});
  EXPECT_EQ(text.str(),
            "0 of 5 done, 2 running\n"
            "1 of 5 done, 2 running, ETA 0:15\n"
            "1 of 5 done, 1 failed, 1 running, ETA 0:23\n");
}

TEST(SweepProgressLine, IsRedrawnOnATerminal) {
  std::ostringstream text;
  double now = 0.0;
  SweepProgress progress({&text, [&] { return now; }, true, 12});
  progress.update({2, 0, 0, {0.0}, 1});
  progress.say("a failed");
  progress.finish();
  EXPECT_EQ(text.str(), "\r\x1b[2K0 of 2 done\r\x1b[2Ka failed\n");
}

}  // namespace
}  // namespace moraine
