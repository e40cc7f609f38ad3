// `moraine blast`: what it prints, writes and refuses; the examples of its help and of its page.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "blast/kingery_bulmash.hpp"
#include "blast/relation.hpp"
#include "output/table_csv.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

/// Words of a command line, as a shell splits them.
std::vector<std::string> words_of(std::string const& line) {
  std::vector<std::string> words;
  std::string word;
  bool quoted = false, open = false;
  for (char const c : line + " ") {
    if (c == '"') {
      quoted = !quoted;
      open = true;
    } else if (c != ' ' || quoted) {
      word += c;
      open = true;
    } else if (open) {
      words.push_back(word);
      word.clear();
      open = false;
    }
  }
  return words;
}

class BlastCommand : public ScratchFolder {
 protected:
  /// Runs "blast ...", or "moraine blast ..." with its first word.
  CommandResult call(std::string const& line) {
    std::vector<std::string> words = words_of(line);
    if (!words.empty() && words.front() == "moraine") words.erase(words.begin());
    return moraine_command(path(""), words);
  }

  nlohmann::json json(std::string const& line) {
    CommandResult const result = call(line + " --json");
    EXPECT_EQ(result.code, 0) << line << "\n" << result.err;
    return nlohmann::json::parse(result.out);
  }

  /// Value of the first estimate of a measure by a relation.
  static double value(nlohmann::json const& answer, std::string const& measure,
                      std::string const& relation) {
    for (auto const& estimate : answer.at("estimates"))
      if (estimate.at("measure") == measure && estimate.at("relation") == relation)
        return estimate.at("value");
    ADD_FAILURE() << measure << " by " << relation << " is missing";
    return 0.0;
  }

  void expect_files(std::vector<std::string> const& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
      if (words[i] == "--csv" || words[i] == "--plot") {
        EXPECT_GT(std::filesystem::file_size(path(words[i + 1])), 500u) << words[i + 1];
      }
  }
};

TEST_F(BlastCommand, ExamplesOfEveryHelpRun) {
  std::vector<std::string> helps{"blast --help"};
  for (int t = 0; t <= static_cast<int>(blast::Topic::bubble); ++t)
    helps.push_back("blast " + std::string(name_of(static_cast<blast::Topic>(t))) + " --help");
  for (std::string const& help : helps) {
    CommandResult const text = call(help);
    EXPECT_EQ(text.code, 0) << help;
    std::istringstream lines(text.out);
    int examples = 0;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("  moraine blast ")) continue;
      CommandResult const result = call(line);
      EXPECT_EQ(result.code, 0) << line << "\n" << result.err;
      EXPECT_EQ(result.err, "") << line;
      EXPECT_FALSE(result.out.empty()) << line;
      expect_files(words_of(line));
      ++examples;
    }
    EXPECT_GE(examples, 1) << help;
  }
}

TEST_F(BlastCommand, HelpNamesWhatItsListsHold) {
  std::string const buried = call("blast buried --help").out;
  for (blast::Soil const& soil : blast::soils())
    EXPECT_NE(buried.find(soil.name), std::string::npos) << soil.name;
  std::string const crater = call("blast crater --help").out;
  for (blast::BrokenGround const& ground : blast::broken_grounds())
    EXPECT_NE(crater.find(ground.name), std::string::npos) << ground.name;
}

// Every `$ moraine blast ...` of docs/blast.md prints what the page says, to the last digit.
TEST_F(BlastCommand, PageHoldsWhatTheProgramSays) {
  std::istringstream page(bytes_of(std::string(MORAINE_SOURCE_DIR) + "/docs/blast.md"));
  int compared = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("$ moraine blast ")) continue;
    std::string expected;
    for (std::string next; std::getline(page, next) && next != "```";) expected += next + '\n';
    CommandResult const result = call(line.substr(2));
    EXPECT_EQ(result.out, expected) << line;
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

TEST_F(BlastCommand, AnswersAreThoseOfTheLibrary) {
  auto const air = json("blast air --charge \"10 kg\" --distance \"5 m\"");
  double const z = 5.0 / std::cbrt(10.0);
  double const peak = blast::kingery_overpressure(blast::Burst::free_air, z);
  EXPECT_NEAR(value(air, "peak_overpressure", "kingery_bulmash"), peak, 1e-9 * peak);
  EXPECT_EQ(air.at("estimates").at(0).at("unit"), "Pa");
  EXPECT_EQ(air.at("input").at("charge"), 10.0);
}

TEST_F(BlastCommand, UnitsGoInAndOut) {
  double const metric = value(json("blast surface --charge \"10 kg\" --distance \"5 m\""),
                              "peak_overpressure", "kingery_bulmash");
  // 10 kg and 5 m in pounds and feet, to the digits written here.
  for (auto const* line :
       {"blast surface --charge \"22.0462262185 lb\" --distance \"16.4041994751 ft\"",
        "blast surface --charge \"10000 g\" --distance \"500 cm\"",
        "blast surface --charge \"0.01 t\" --distance \"0.005 km\""})
    EXPECT_NEAR(value(json(line), "peak_overpressure", "kingery_bulmash"), metric, 1e-9 * metric)
        << line;
  std::string const same = "blast surface --charge \"10 kg\" --distance \"5 m\"";
  EXPECT_NEAR(value(json(same + " --units imperial"), "peak_overpressure", "kingery_bulmash"),
              metric / 6894.757293168, 1e-9 * metric / 6894.757293168);
  EXPECT_NEAR(value(json(same + " --pressure-unit bar"), "peak_overpressure", "kingery_bulmash"),
              metric / 1e5, 1e-9 * metric / 1e5);
  EXPECT_NEAR(value(json(same + " --units metric"), "impulse", "kingery_bulmash"),
              value(json(same), "impulse", "kingery_bulmash"), 1e-9);  // kPa ms are Pa s
}

TEST_F(BlastCommand, ExplosivesByTheirFactors) {
  std::string const place = " --charge \"10 kg\" --distance \"5 m\"";
  auto const peak = [&](std::string const& more) {
    return value(json("blast air" + place + more), "peak_overpressure", "kingery_bulmash");
  };
  EXPECT_NEAR(peak(" --explosive tritonal") / peak(""), 1.17, 1e-12);
  EXPECT_NEAR(peak(" --pressure-factor 1.5") / peak(""), 1.5, 1e-12);
  EXPECT_DOUBLE_EQ(peak(" --explosive c4"), peak(" --mass-factor 1.34"));
  auto const heavier = json("blast air --charge \"13.4 kg\" --distance \"5 m\"");
  EXPECT_NEAR(peak(" --explosive c4"), value(heavier, "peak_overpressure", "kingery_bulmash"),
              1e-6);
}

TEST_F(BlastCommand, PulseOfAChargeCarriesItsImpulse) {
  auto const air = json("blast air --charge \"10 kg\" --distance \"5 m\"");
  auto const pulse = json("blast pulse --charge \"10 kg\" --distance \"5 m\" --time \"0 s\"");
  double const impulse = value(air, "impulse", "kingery_bulmash");
  EXPECT_NEAR(value(pulse, "impulse", "friedlander"), impulse, 1e-9 * impulse);
  double const peak = value(air, "peak_overpressure", "kingery_bulmash");
  EXPECT_NEAR(value(pulse, "overpressure", "friedlander"), peak, 1e-9 * peak);
  EXPECT_EQ(pulse.at("notes").at(0), "peak, duration and impulse by kingery_bulmash");
}

TEST_F(BlastCommand, WarnsOfAFrontThatIsDerivedOutsideItsRange) {
  auto const far = json("blast reflection --charge \"1 g\" --distance \"50 m\"");
  EXPECT_EQ(far.at("notes").size(), 2u);
  std::string const note = far.at("notes").at(1);
  EXPECT_TRUE(note.starts_with("warning: that is outside its range")) << note;
  CommandResult const table = call(
      "blast reflection --charge \"1 g\" --distance \"50 m\" --angles 0deg 10deg 3 --csv a.csv");
  EXPECT_NE(table.out.find("warning: that is outside its range"), std::string::npos) << table.err;
  auto const high =
      json("blast pulse --charge \"1 kg\" --distance \"5 m\" --ambient-pressure \"70 kPa\"");
  EXPECT_NE(high.at("notes").at(1).get<std::string>().find("at sea level"), std::string::npos);
}

TEST_F(BlastCommand, TablesRunAlongARange) {
  CommandResult const result =
      call("blast water --charge \"50 kg\" --distances \"2 m\" \"200 m\" 5 --csv a.csv");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, "a.csv\n");
  Table const table = read_table_csv(path("a.csv"));
  auto const& distance = *table.find("distance");
  ASSERT_EQ(distance.size(), 5u);
  EXPECT_EQ(distance.front(), 2.0);
  EXPECT_NEAR(distance[2], 20.0, 1e-12);  // evenly spread by ratio
  EXPECT_EQ(distance.back(), 200.0);
  auto const& peak = *table.find("peak pressure cole");
  auto const single = json("blast water --charge \"50 kg\" --distance \"20 m\"");
  EXPECT_NEAR(peak[2], value(single, "peak_pressure", "cole"), 1e-9 * peak[2]);
  auto const along = json("blast water --charge \"50 kg\" --distances \"2 m\" \"200 m\" 5");
  EXPECT_EQ(along.at("points").size(), 5u);
  EXPECT_EQ(along.at("points").at(4).at("at"), 200.0);
}

TEST_F(BlastCommand, SweptChargesCountInTnt) {
  auto const along = json("blast crater --explosive c4 --charges \"1 lb\" \"8 lb\" 2");
  EXPECT_EQ(along.at("unit"), "lb");
  double const first = along.at("points").at(0).at("estimates").at(0).at("value");
  EXPECT_NEAR(first, 0.8 * std::cbrt(0.45359237 * 1.34), 1e-12);
  double const last = along.at("points").at(1).at("estimates").at(0).at("value");
  EXPECT_NEAR(last / first, 2.0, 1e-12);
}

TEST_F(BlastCommand, ListsRelationsWithSources) {
  auto const all = nlohmann::json::parse(call("blast --list --json").out);
  EXPECT_EQ(all.size(), blast::relations().size());
  auto const crater = nlohmann::json::parse(call("blast crater --list --json").out);
  EXPECT_EQ(crater.size(), 6u);
  for (auto const& relation : crater) EXPECT_EQ(relation.at("topic"), "crater");
  EXPECT_NE(call("blast --list").out.find("ARBRL-TR-02555"), std::string::npos);
}

TEST_F(BlastCommand, TellsAllMistakesAtOnceAndWritesNothing) {
  CommandResult const result = call(
      "blast air --charge \"10 s\" --distance \"-5 m\" --explosive tnd --units metrc "
      "--pressure-unit m --csv a.csv --plott a.svg");
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(
      result.err,
      "moraine blast air: \"--plott\" is not an option; did you mean \"--plot\"?\n"
      "moraine blast air: \"a.svg\" is not an option; see --help\n"
      "moraine blast air: --charge: \"10 s\" is a time; a mass is expected (kg)\n"
      "moraine blast air: --distance: \"-5 m\" must be above zero\n"
      "moraine blast air: --explosive: \"tnd\" is not in the list; did you mean \"tnt\"?\n"
      "moraine blast air: --units: \"metrc\" is not a system of units; did you mean "
      "\"metric\"?\n"
      "moraine blast air: --pressure-unit: \"m\" is a length; a pressure is expected (Pa)\n"
      "moraine blast air: --csv: needs a range of values; add --distances FIRST LAST COUNT\n");
  EXPECT_FALSE(std::filesystem::exists(path("a.csv")));
}

struct Mistake {
  char const* line;
  char const* message;
};

TEST_F(BlastCommand, SaysWhatIsWrong) {
  for (auto const& [line, message] : {
           Mistake{"blast air --distance \"5 m\"",
                   "moraine blast air: --charge: is missing: mass of the charge; give a mass\n"},
           Mistake{"blast watr",
                   "moraine blast: \"watr\" is not a topic; did you mean \"water\"?\n"},
           Mistake{"blast air --charge 10 --distance \"5 m\"",
                   "moraine blast air: --charge: \"10\" is a plain number; a mass is expected "
                   "(kg); write \"10 kg\"\n"},
           Mistake{"blast air --charge \"1 kg\" --distance \"1 m\" --distances \"1 m\" \"2 m\" 5",
                   "moraine blast air: --distance: \"1 m\" and --distances exclude each other\n"},
           Mistake{"blast air --charge \"1 kg\" --distances \"5 m\" \"1 m\" 5",
                   "moraine blast air: --distances: \"1 m\" must be above the first value\n"},
           Mistake{"blast air --charge \"1 kg\" --distances \"1 m\" \"5 m\" 1",
                   "moraine blast air: --distances: \"1\" is not a number of points from 2 to "
                   "10000\n"},
           Mistake{"blast reflection",
                   "moraine blast reflection: --pressure: is missing: overpressure of the incident "
                   "front or peak of the pulse; give a pressure, or --charge and --distance\n"},
           Mistake{"blast reflection --pressure \"1 bar\" --angle \"90 deg\"",
                   "moraine blast reflection: --angle: \"90 deg\" must be at least 0 and below 90 "
                   "deg\n"},
           Mistake{"blast buried --charge \"1 kg\" --distance \"2 m\" --soil loma --coupling 1.2",
                   "moraine blast buried: --coupling: \"1.2\" must be above 0 and at most 1\n"
                   "moraine blast buried: --soil: \"loma\" is not in the list; did you mean "
                   "\"loam\"?\n"},
           Mistake{"blast buried --charge \"1 kg\" --distance \"2 m\" --soil loam --depth \"1 cm\"",
                   "moraine blast buried: --coupling: is missing: the depth is 0.0252 ft/lb^(1/3), "
                   "below 2; give a number of at most 1\n"},
           Mistake{"blast pulse --pressure \"1 kPa\" --duration \"1 ms\" --impulse \"1 kPa ms\"",
                   "moraine blast pulse: --impulse: \"1 kPa ms\" fits no decay: it must be above "
                   "zero and at most half of peak times duration\n"},
           Mistake{"blast air --charge \"1 kg\" --distances \"1 m\" \"5 m\" 3 --plot a.pdf",
                   "moraine blast air: --plot: \"a.pdf\" must end in .svg or .png\n"},
       }) {
    CommandResult const result = call(line);
    EXPECT_EQ(result.code, 2) << line;
    EXPECT_EQ(result.err, message) << line;
    EXPECT_EQ(result.out, "") << line;
  }
}

TEST_F(BlastCommand, SaysWhenItCannotWrite) {
  write(path("file"), "");
  CommandResult const result =
      call("blast air --charge \"1 kg\" --distances \"1 m\" \"5 m\" 3 --csv file/a.csv");
  EXPECT_EQ(result.code, 4) << result.err;
}

}  // namespace
}  // namespace moraine
