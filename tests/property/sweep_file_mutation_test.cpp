// Random changes of sweep files: each gives a plan whose members are good, or mistakes with their
// rules, and nothing else.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "setup/read_case.hpp"
#include "sweep/read_sweep.hpp"
#include "sweep/sweep_folder.hpp"
#include "unit/output/scratch_folder.hpp"
#include "unit/sweep/sample_case.hpp"

namespace moraine {
namespace {

std::vector<std::string> const pieces{
    "case = \"sample.toml\"\n",
    "method = \"grid\"\n",
    "method = \"list\"\n",
    "method = \"latin_hypercube\"\nsamples = 3\n",
    "at_once = 2\n",
    "[[parameter]]\n",
    "[[output]]\n",
    "key = \"resolution.spacing\"\n",
    "key = \"gauge.1.5 cm.position\"\n",
    "keys = [\"time.end\", \"numerics.precision\"]\n",
    "keys = [\"resolution\", 3]\n",
    "values = [[\"1 ms\", \"double\"], [2e-3, \"mixed\"]]\n",
    "values = [\"1 cm\", 0.02]\n",
    "values = [nan, inf, -1, \"\"]\n",
    "values = [[0.1, 0.2], [1979-05-27, {}]]\n",
    "range = [1e-2, \"2 cm\"]\n",
    "range = [0, 1, 2]\n",
    "range = [inf, nan]\n",
    "steps = 2\n",
    "steps = 100000\n",
    "scale = \"log\"\n",
    "label = \"x\"\n",
    "label = [\"x\", \"y\"]\n",
    "label = [1]\n",
    "gauge = \"top\"\n",
    "gauge = \"1\"\ncolumn = \"pressure\"\n",
    "sums = \"mass\"\n",
    "run = \"steps\"\n",
    "measure = \"peak\"\n",
    "measure = \"arrival\"\n",
    "measure = 3\n",
    "parameter = 3\n",
    "output = [3]\n",
    "\"\" = 1\n",
};

class SweepFileMutation : public ScratchFolder {};

TEST_F(SweepFileMutation, GivesMembersOrMistakes) {
  write(path("sample.toml"), sample_case);
  std::mt19937_64 random(20);
  auto const pick = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  int good = 0, refused = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    std::string text = pieces[0] + pieces[1 + pick(3)] + "[[parameter]]\n" + pieces[7 + pick(2)] +
                       pieces[12 + pick(4)];
    for (std::size_t more = pick(8); more > 0; --more) text += pieces[pick(pieces.size())];
    write(path("sweep.toml"), text);
    try {
      Sweep const sweep = read_sweep(path("sweep.toml"));
      ASSERT_FALSE(sweep.plan.members.empty()) << text;
      for (auto const& member : member_places(sweep, path("out")))
        EXPECT_NO_THROW(parse_case(member.case_text, "member.toml")) << text << member.case_text;
      ++good;
    } catch (InputErrors const& errors) {
      for (auto const& problem : errors.problems()) EXPECT_FALSE(problem.rule.empty()) << text;
      ++refused;
    }
  }
  EXPECT_GT(good, 20);
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace moraine
