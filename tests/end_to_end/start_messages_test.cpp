// What is said of a case that starts from another run: doubts and refusals.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <string>

#include "end_to_end/start_from_a_run.hpp"
#include "setup/case_report.hpp"

namespace moraine {
namespace {

class WarningsOfAStart : public StartFromARun {
 protected:
  std::string warnings(std::string const& text) {
    std::string all;
    for (auto const& warning : report_case(started(text)).warnings) all += format(warning) + '\n';
    return all;
  }
};

TEST_F(WarningsOfAStart, DoubtsOtherConstantsAndRunsThatAreNotOver) {
  EXPECT_EQ(warnings(pool("0.01") + from_settled).find("start.run"), std::string::npos);
  EXPECT_NE(
      warnings(pool("0.01", "90") + from_settled)
          .find("material.water: is another one in the run that the case starts from: "
                "\"reference_sound_speed = 100.0  # m/s\" there, \"reference_sound_speed = 90.0  "
                "# m/s\" here; its particles keep density and energy, not pressure"),
      std::string::npos)
      << warnings(pool("0.01", "90") + from_settled);
  std::string half(water);
  half.replace(half.find("0.6, 0.4"), 8, "0.5, 0.5");
  EXPECT_NE(warnings(pool("0.01") + from_settled + half)
                .find("start.run: \"settled\" loses 500 of its 600 particles to regions of this "
                      "case"),
            std::string::npos)
      << warnings(pool("0.01") + from_settled + half);
  write(path("settle.toml"), pool("100") + water);
  Program program(path(""), {"run", "settle.toml", "-o", "unfinished"});
  wait_for_checkpoints("unfinished", 1);
  program.send(SIGINT);
  ASSERT_EQ(program.wait().code, 130);
  std::string unfinished = pool("0.01") + from_settled;
  unfinished.replace(unfinished.find("\"settled\""), 9, "\"unfinished\"");
  std::string const text = warnings(unfinished);
  EXPECT_NE(text.find("start.run: \"unfinished\" had not reached its end: the state is that of "),
            std::string::npos)
      << text;
}

TEST_F(WarningsOfAStart, DoubtsTooShortAReachAndWeightThatIsNotCounted) {
  write(path("coarse.toml"), pool("0.001") + water + "spacing = 0.025\n");
  ASSERT_EQ(run("coarse.toml", "coarse").code, 0);
  std::string next = pool("0.01") + from_settled + R"([[region]]
name = "bed"
material = "water"
box = { min = [0.7, 0.0], max = [0.9, 0.2] }
lithostatic_load = 0.0
)";
  next.replace(next.find("\"settled\""), 9, "\"coarse\"");
  EXPECT_EQ(warnings(next).find("makes the smoothing length"), std::string::npos) << warnings(next);
  EXPECT_NE(warnings(next).find("region.bed.lithostatic_load: 0.0 counts the weight of the regions "
                                "above alone, not that of particles which come from the other run"),
            std::string::npos)
      << warnings(next);
  next.replace(next.find("resolution.spacing = 0.02"), 25,
               "resolution = { spacing = 0.02, smoothing_factor = 0.9 }");
  EXPECT_NE(
      warnings(next).find("resolution.smoothing_factor: 0.9 makes the smoothing length 0.018 m, "
                          "0.72 of the widest spacing, 0.025 m, that comes from the other "
                          "run; particles would hardly feel their neighbours: raise it"),
      std::string::npos)
      << warnings(next);
}

TEST_F(StartFromARun, RefusesWhatDoesNotGoTogether) {
  auto const swapped = [](std::string text, std::string const& from, std::string const& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  std::string const good = pool("0.01") + from_settled;
  EXPECT_EQ(mistake(swapped(good, "\"settled\"", "\"setled\"")),
            "20:7: start.run: \"setled\" is not a folder; name the folder of a run; its path "
            "counts from the case file");
  EXPECT_EQ(
      mistake(swapped(good, "[start]\nrun = \"settled\"\n", "[start]\nvelocities = \"zero\"\n")),
      "19:1: start.run: is missing: folder of another run, from whose newest checkpoint the "
      "case takes its particles; its path counts from the case file");
  std::filesystem::create_directories(path("empty"));
  EXPECT_EQ(mistake(swapped(good, "\"settled\"", "\"empty\"")),
            "20:7: start.run: \"empty\" holds no run; name the folder of a run");
  EXPECT_EQ(mistake(swapped(good, "spacing = 0.02", "spacing = 0.01")),
            "3:22: resolution.spacing: 0.01 differs from the spacing of the run that the case "
            "starts from, 0.02 m");
  EXPECT_EQ(mistake(swapped(good, "[material.water]", "[material.watr]")),
            "20:7: start.run: \"settled\" holds particles of the material \"water\", which this "
            "case does not have; did you mean \"watr\"?");
  EXPECT_EQ(mistake("space.dimension = 1\nresolution.spacing = 0.02\ntime.end = 1\n"
                    "[space.domain]\nmin = [0]\nmax = [1]\n"
                    "[material.water]\neos = \"tait\"\n" +
                    std::string(from_settled)),
            "1:19: space.dimension: 1 differs from the dimension of the run that the case starts "
            "from, 2");
  std::string const narrow = mistake(swapped(good, "max = [1, 0.8]", "max = [0.5, 0.8]"));
  EXPECT_TRUE(narrow.starts_with("20:7: start.run: \"settled\" has ")) << narrow;
  EXPECT_NE(narrow.find(" particles inside a wall, the first at (0.5"), std::string::npos)
      << narrow;
  EXPECT_EQ(
      mistake(good + swapped(water, "max = [0.6, 0.4]", "max = [1, 0.8]")),
      "20:7: start.run: \"settled\" has no particle that stays: regions of this case fill all "
      "their places; leave out the regions that the other run began with");
  std::string small = swapped(good, "max = [1, 0.8]", "max = [0.3, 0.8]");
  small = mistake(swapped(small, "[0.96, 0.05]", "[0.2, 0.05]") +
                  "[space.domain]\nmin = [0, 0]\nmax = [0.3, 0.8]\n");
  EXPECT_NE(small.find(" particles outside the domain, the first at (0.3"), std::string::npos)
      << small;
}

TEST_F(StartFromARun, RefusesDamagedStatesAndItsOwnFolder) {
  std::string const good = pool("0.001") + from_settled;
  write(path("next.toml"), good);
  CommandResult const own =
      moraine_command(path(""), {"run", "next.toml", "-o", "settled", "--force"});
  EXPECT_EQ(own.code, 2);
  EXPECT_NE(own.err.find("next.toml:20:7: start.run: \"settled\" is the folder of this run's own "
                         "results; choose another folder with --output"),
            std::string::npos)
      << own.err;
  ASSERT_EQ(run("next.toml", "next").code, 0);
  write(path("next/start.h5"), "moraine checkpoint, cut");
  std::filesystem::remove(path("next/manifest.json"));  // as if it was killed
  CommandResult const resumed = moraine_command(path(""), {"resume", "next"});
  EXPECT_EQ(resumed.code, 1);
  EXPECT_NE(resumed.err.find("start.h5 is cut off: the state that the run started from is lost"),
            std::string::npos)
      << resumed.err;
  for (auto const& entry : std::filesystem::directory_iterator(path("settled/checkpoints")))
    write(entry.path(), "moraine checkpoint, cut");
  std::string const text = mistake(good);
  EXPECT_TRUE(text.starts_with("20:7: start.run: \"settled\" has no whole checkpoint; ")) << text;
  EXPECT_NE(text.find(" is cut off"), std::string::npos) << text;
}

}  // namespace
}  // namespace moraine
