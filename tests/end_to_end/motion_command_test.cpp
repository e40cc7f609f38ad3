// `moraine motion` and `moraine slosh`: their examples, pages, messages and files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "base/gravity.hpp"
#include "end_to_end/small_case.hpp"
#include "records/record_reader.hpp"
#include "support/help_examples.hpp"
#include "support/places.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class MotionCommand : public ScratchFolder {
 protected:
  CommandResult call(std::vector<std::string> const& arguments) {
    return moraine_command(path(""), arguments);
  }
  CommandResult call_line(std::string const& line) { return call(words_of_command(line)); }

  /// Two seconds of a sine in g at steps of 0.01 s.
  void write_sine(std::string const& name, double amplitude = 0.1) {
    std::string text = "t_s,a_g\n";
    for (int i = 0; i <= 200; ++i)
      text += std::to_string(0.01 * i) + "," +
              std::to_string(amplitude * std::sin(0.04 * 3.14159265358979 * i)) + "\n";
    write(path(name), text);
  }

  /// One of the last digit shown: 0.001 of "0.105".
  static double last_digit(std::string const& number) {
    auto const point = number.find('.');
    auto const end = std::min(number.find('e'), number.size());
    double const exponent = end < number.size() ? std::stod(number.substr(end + 1)) : 0.0;
    return std::pow(10.0, exponent - (point < end ? static_cast<double>(end - point - 1) : 0.0));
  }

  /// Whether two texts are the same, but for one in the last digit of a number, or a part in a
  /// thousand of it.
  static testing::AssertionResult alike(std::string const& shown, std::string const& printed) {
    std::istringstream a(shown), b(printed);
    std::string word, other;
    while (a >> word) {
      if (!(b >> other)) return testing::AssertionFailure() << "ends before " << word;
      if (word == other) continue;
      char* end_a = nullptr;
      char* end_b = nullptr;
      double const x = std::strtod(word.c_str(), &end_a), y = std::strtod(other.c_str(), &end_b);
      double const slack = std::max(1e-3 * std::fabs(x), 1.01 * last_digit(word));
      if (*end_a != '\0' || *end_b != '\0' || std::fabs(x - y) > slack)
        return testing::AssertionFailure() << word << " is shown, " << other << " printed";
    }
    if (b >> other) return testing::AssertionFailure() << other << " is printed and not shown";
    return testing::AssertionSuccess();
  }

  void expect_page(std::string const& page) {
    auto const shown = shown_commands(bytes_of(source_folder() + page));
    ASSERT_GE(shown.size(), 3u) << page;
    for (ShownCommand const& example : shown) {
      CommandResult const result = call_line(example.command);
      EXPECT_EQ(result.code, 0) << example.command << '\n' << result.err;
      EXPECT_TRUE(alike(example.output, result.out)) << example.command << '\n' << result.out;
    }
  }
};

// Every example of the help runs, one after the other in one folder.
TEST_F(MotionCommand, ExamplesOfTheHelpRun) {
  for (auto const& command : {std::vector<std::string>{"motion", "--help"},
                              {"motion", "synthesise", "--help"},
                              {"slosh", "--help"}}) {
    CommandResult const help = call(command);
    ASSERT_EQ(help.code, 0);
    auto const examples = commands_in(help.out, "  ");
    EXPECT_GE(examples.size(), 2u) << help.out;
    for (std::string const& example : examples) {
      CommandResult const result = call_line(example);
      EXPECT_EQ(result.code, 0) << example << '\n' << result.err;
      EXPECT_FALSE(result.out.empty()) << example;
    }
    std::filesystem::remove(path("quake.csv"));
  }
}

// What the pages print is what the commands print.
TEST_F(MotionCommand, PageOfMotionsIsTrue) { expect_page("/docs/motion.md"); }
TEST_F(MotionCommand, PageOfSloshingIsTrue) { expect_page("/docs/slosh.md"); }

TEST_F(MotionCommand, SameSeedSameFile) {
  std::vector<std::string> const arguments{
      "motion", "synthesise", "--pga", "0.35 g0",     "--pgv-pga", "96 ms",  "--predominant-period",
      "0.28 s", "--duration", "8 s",   "--time-step", "0.01 s",    "--seed", "3",
      "--write"};
  auto const made = [&](std::string const& seed, std::string const& name) {
    auto all = arguments;
    all[13] = seed;
    all.push_back(name);
    CommandResult const result = call(all);
    EXPECT_EQ(result.code, 0) << result.err;
    return bytes_of(path(name));
  };
  std::string const first = made("3", "a.csv");
  EXPECT_EQ(made("3", "b.csv"), first);
  EXPECT_NE(made("4", "c.csv"), first);
  GroundRecord const record = read_record(path("a.csv"), {});
  EXPECT_NEAR(peak_of(record, record.acceleration).value, 0.35 * standard_gravity, 1e-12);
}

TEST_F(MotionCommand, TellsOfAFitThatIsNotClose) {
  CommandResult const result =
      call({"motion", "synthesise", "--pga", "1", "--pgv-pga", "0.01", "--predominant-period",
            "0.5", "--duration", "6", "--time-step", "0.02", "--json"});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.err.find("no motion within 0.5 % was found"), std::string::npos) << result.err;
  EXPECT_GT(nlohmann::json::parse(result.out).at("largest_relative_error"), 0.2);
}

TEST_F(MotionCommand, ProcessesAndPutsRecordsSideBySide) {
  write_sine("quake.csv");
  write_sine("other.csv", 0.2);
  CommandResult const result = call(
      {"motion", "quake.csv", "other.csv", "--pga", "0.35 g0", "--time-scale", "0.5", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  auto const json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json.size(), 2u);
  for (auto const& entry : json) {
    EXPECT_NEAR(entry.at("peak_acceleration_m_s2"), 0.35 * standard_gravity, 1e-12);
    EXPECT_NEAR(entry.at("duration_s"), 1.0, 1e-12);
    // PGV of a sine of 4 Hz from rest: A/(pi f).
    EXPECT_NEAR(entry.at("peak_velocity_m_s"), 0.35 * standard_gravity / (4.0 * 3.14159265), 1e-3);
  }
}

TEST_F(MotionCommand, TellsOfAllMistakesTogether) {
  write_sine("quake.csv");
  write(path("bare.txt"), "0.1\n0.2\n0.1\n");
  write(path("short.AT2"),
        "a\nb\nACCELERATION IN UNITS OF G\nNPTS= 9, DT= .005 SEC\n 0.1 0.2 0.3\n");
  CommandResult const result =
      call({"motion", "quake.csv", "bare.txt", "short.AT2", "none.csv", "--pga", "0.35 g",
            "--baseline", "liner", "--write", "all.csv", "--plot", "all.pdf"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  for (auto const* part :
       {"--pga: \"0.35 g\" is a mass; an acceleration is expected (m/s^2); g is gram; did you mean "
        "\"0.35 g0\"",
        "--baseline: \"liner\" is no baseline correction; did you mean \"linear\"?",
        "--write: \"all.csv\" is one file for several records",
        "--plot: \"all.pdf\" is no picture; end its name with .svg or .png",
        "bare.txt: does not say its time step", "bare.txt: does not say the unit",
        "short.AT2:4:1: NPTS 9 is not the number of values, 3", "none.csv: does not exist"})
    EXPECT_NE(result.err.find(part), std::string::npos) << part << "\nin\n" << result.err;
  EXPECT_FALSE(std::filesystem::exists(path("all.csv")));
}

TEST_F(MotionCommand, TellsOfStepsThatAreTooCoarse) {
  write_sine("quake.csv");
  CommandResult const spectrum = call({"motion", "quake.csv", "--shortest-period", "0.02 s"});
  EXPECT_EQ(spectrum.code, 2);
  EXPECT_EQ(spectrum.err,
            "quake.csv: a step of 0.01 s is too coarse for a spectrum from 0.02 s; its shortest "
            "period is 0.05 s, five steps\n");
  CommandResult const measures = call({"motion", "quake.csv", "--time-scale", "4"});
  EXPECT_EQ(measures.code, 2);
  EXPECT_NE(measures.err.find("a step of 0.04 s is too coarse for the spectra of the measures"),
            std::string::npos);
  EXPECT_EQ(call({"motion", "quake.csv", "--time-scale", "4", "--resample", "20 ms"}).code, 0);
}

TEST_F(MotionCommand, OverwritesNothingUnasked) {
  write_sine("quake.csv");
  std::string const before = bytes_of(path("quake.csv"));
  CommandResult const result = call({"motion", "quake.csv", "--pga", "1", "--write", "quake.csv"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "moraine motion: --write: \"quake.csv\" exists and is not overwritten; name another "
            "file or add --force\n");
  EXPECT_EQ(bytes_of(path("quake.csv")), before);
  EXPECT_EQ(call({"motion", "quake.csv", "--pga", "1", "--write", "quake.csv", "--force"}).code, 0);
  EXPECT_NE(bytes_of(path("quake.csv")), before);
}

// Nor pictures, nor one output by another.
TEST_F(MotionCommand, OverwritesNoPictureUnasked) {
  write_sine("quake.csv");
  write(path("m-spectra.svg"), "mine");
  CommandResult const result = call({"motion", "quake.csv", "--plot", "m.svg"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "moraine motion: --plot: \"m-spectra.svg\" exists and is not overwritten; name another "
            "file or add --force\n");
  EXPECT_EQ(bytes_of(path("m-spectra.svg")), "mine");
  EXPECT_EQ(call({"motion", "quake.csv", "--plot", "m.svg", "--force"}).code, 0);
  EXPECT_GT(bytes_of(path("m-spectra.svg")).size(), 1000u);
  CommandResult const slosh =
      call({"slosh", "--length", "1", "--depth", "1", "--record", "quake.csv", "--plot", "m.svg"});
  EXPECT_EQ(slosh.code, 2);
  EXPECT_NE(slosh.err.find("--plot: \"m.svg\" exists"), std::string::npos) << slosh.err;
  CommandResult const twice =
      call({"motion", "quake.csv", "--write", "a.csv", "--write-displacement", "./a.csv"});
  EXPECT_EQ(twice.code, 2);
  EXPECT_EQ(twice.err,
            "moraine motion: --write-displacement: \"./a.csv\" is what --write writes too; name "
            "another file\n");
  EXPECT_FALSE(std::filesystem::exists(path("a.csv")));
}

TEST_F(MotionCommand, WarnsOfPeaksAndPeriodsThatAreHardToBelieve) {
  write_sine("quake.csv", 30.0);
  std::string const unit = "a peak of 29.9 g is more than any earthquake had";
  EXPECT_NE(call({"motion", "quake.csv"}).err.find(unit), std::string::npos);
  EXPECT_NE(
      call({"slosh", "--length", "9", "--depth", "9", "--record", "quake.csv"}).err.find(unit),
      std::string::npos);
  EXPECT_EQ(call({"motion", "quake.csv", "--pga", "0.3 g0", "--baseline", "rest"}).err, "");
  // A sine of 40 Hz, above what oscillators of five steps can tell.
  std::string text = "t_s,a_g\n";
  for (int i = 0; i <= 200; ++i)
    text += fmt::format("{},{}\n", 0.01 * i, 0.1 * std::sin(0.8 * 3.14159265358979 * i));
  write(path("fast.csv"), text);
  EXPECT_NE(call({"motion", "fast.csv", "--baseline", "rest"})
                .err.find("largest at 0.05 s, an end of the periods looked at (0.05 to 4 s)"),
            std::string::npos);
}

// Steps so fine that they hold no second of motion are refused, and do not run for ever.
TEST_F(MotionCommand, RefusesWhatCannotBeMeasured) {
  write_sine("quake.csv");
  CommandResult const tiny = call({"motion", "quake.csv", "--time-scale", "1e-300"});
  EXPECT_EQ(tiny.code, 2);
  EXPECT_TRUE(tiny.err.starts_with("quake.csv: Butterworth filter: the corner, 9 Hz")) << tiny.err;
  CommandResult const film = call({"slosh", "--length", "2", "--depth", "1e-9"});
  EXPECT_EQ(film.code, 2);
  EXPECT_EQ(film.err, "moraine slosh: rigid tank: length over depth must be 0.0001 to 10000\n");
  CommandResult const seed = call({"motion", "synthesize", "--pga", "1", "--pgv-pga", "0.1",
                                   "--predominant-period", "0.3", "--seed", "-1"});
  EXPECT_EQ(seed.code, 2);
  EXPECT_NE(seed.err.find("-1 is negative"), std::string::npos) << seed.err;
}

TEST_F(MotionCommand, WarnsOfDrift) {
  std::string text = "t_s,a_g\n";
  for (int i = 0; i <= 400; ++i)
    text += fmt::format("{},{}\n", 0.01 * i, 0.01 + 0.3 * std::sin(0.1 * 3.14159265358979 * i));
  write(path("drift.csv"), text);
  EXPECT_NE(call({"motion", "drift.csv"}).err.find("drift more likely than ground"),
            std::string::npos);
  EXPECT_EQ(call({"motion", "drift.csv", "--baseline", "rest"}).err, "");
}

// A record becomes the motion of a wall, which a case takes.
TEST_F(MotionCommand, DisplacementMovesAWall) {
  write_sine("quake.csv", 0.01);
  ASSERT_EQ(
      call({"motion", "quake.csv", "--baseline", "rest", "--write-displacement", "motion.csv"})
          .code,
      0);
  std::string text = small_case();
  std::string const wall = "container = { min = [0.0, 0.0], max = [0.6, 0.4] }\n";
  text.insert(text.find(wall) + wall.size(), "motion.file = \"motion.csv\"\n");
  write(path("case.toml"), text);
  CommandResult const result = call({"check", "case.toml"});
  EXPECT_EQ(result.code, 0) << result.err;
}

TEST_F(MotionCommand, SloshTellsOfAllMistakesTogether) {
  CommandResult const result =
      call({"slosh", "--length", "0", "--depth", "3 kg", "--damping", "2", "--record", "none.csv",
            "--record", "other.csv", "--write", "h.csv", "--unit", "furlong"});
  EXPECT_EQ(result.code, 2);
  for (auto const* part :
       {"--length: \"0\" is not positive", "--depth: \"3 kg\" is a mass; a length is expected (m)",
        "--damping: 2 is no damping ratio", "none.csv: does not exist", "other.csv: does not exist",
        "--write: \"h.csv\" is one file for several records",
        "--unit: \"furlong\" is no unit of acceleration; choose g, m/s2 or cm/s2"})
    EXPECT_NE(result.err.find(part), std::string::npos) << part << "\nin\n" << result.err;
  write_sine("quake.csv");
  CommandResult const endless = call(
      {"slosh", "--length", "1", "--depth", "1", "--record", "quake.csv", "--free-time", "1e9 s"});
  EXPECT_EQ(endless.code, 2);
  EXPECT_EQ(endless.err,
            "quake: tank response: the free time must be positive, at most 1e7 steps\n");
  CommandResult const lonely = call({"slosh", "--length", "1", "--depth", "1", "--plot", "a.svg"});
  EXPECT_EQ(lonely.code, 2);
  EXPECT_EQ(lonely.err, "moraine slosh: --plot: \"a.svg\" needs a record; add --record FILE\n");
}

TEST_F(MotionCommand, SloshWarnsOfStepsThatMissPeaks) {
  write(path("coarse.csv"), "t_s,a_g\n0,0\n0.5,0.001\n1,-0.001\n1.5,0\n");
  std::vector<std::string> arguments{"slosh", "--length", "2",         "--depth",
                                     "1",     "--record", "coarse.csv"};
  CommandResult const result = call(arguments);
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(
      result.err,
      "warning: coarse: peaks lie between steps of 0.5 s, since the first mode has a period of "
      "1.67 s; --resample makes finer steps\n");
  arguments.insert(arguments.end(), {"--resample", "0.05 s", "--straight-lines"});
  EXPECT_EQ(call(arguments).err, "");
}

TEST_F(MotionCommand, SloshWarnsOfHighWaves) {
  write_sine("quake.csv", 0.5);
  CommandResult const result = call({"slosh", "--length", "2 m", "--depth", "30 cm", "--record",
                                     "quake.csv", "--freeboard", "5 cm", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("linear theory is for small ones"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("above the freeboard of 0.05 m"), std::string::npos) << result.err;
  auto const json = nlohmann::json::parse(result.out);
  double const share = json.at("linear_theory").at("impulsive_share");
  EXPECT_GT(json.at("housner").at("impulsive_share"), share);
  EXPECT_EQ(json.at("responses").size(), 1u);
  EXPECT_EQ(json.at("modes").size(), 5u);
}

}  // namespace
}  // namespace moraine
