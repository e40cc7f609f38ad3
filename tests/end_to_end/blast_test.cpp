// `moraine blast`: what it prints and writes; the examples of its help and of its page.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "blast/kingery_bulmash.hpp"
#include "blast/relation.hpp"
#include "end_to_end/blast_command.hpp"
#include "output/table_csv.hpp"
#include "support/places.hpp"

namespace moraine {
namespace {

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
  std::istringstream page(bytes_of(source_folder() + "/docs/blast.md"));
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

// A gauge of a run, as `gauges.json` tells of it, beside the relations.
TEST_F(BlastCommand, SetsAGaugeBesideTheRelations) {
  write(path("gauges.json"), R"({"gauges": [
    {"name": "lake", "seen": true, "columns": {"lake level": {"unit": "m", "largest": 1.0}}},
    {"name": "A", "seen": true, "columns": {
      "A density": {"unit": "kg/m^3", "first": 1.2, "largest": 3.0},
      "A pressure": {"unit": "Pa", "first": 101325.0, "largest": 241325.0, "impulse": 170.0,
                     "arrival": 0.0055}}},
    {"name": "B", "seen": false, "columns": {"B pressure": {"unit": "Pa", "first": null,
      "largest": null, "impulse": 0.0}}}]})");
  std::string const line = "blast air --charge \"10 kg\" --distance \"5 m\" --gauges gauges.json";
  auto const answer = json(line + " --gauge A");
  auto const& readings = answer.at("gauge").at("readings");
  ASSERT_EQ(readings.size(), 3u);
  double const peak = value(answer, "peak_overpressure", "kingery_bulmash");
  EXPECT_EQ(readings[0].at("measure"), "peak_overpressure");
  EXPECT_EQ(readings[0].at("value"), 140000.0);
  EXPECT_EQ(readings[0].at("relation"), "kingery_bulmash");
  EXPECT_NEAR(readings[0].at("ratio"), 140000.0 / peak, 1e-12);
  EXPECT_EQ(readings[1].at("measure"), "impulse");
  EXPECT_EQ(readings[2].at("measure"), "arrival_time");
  std::string const text = call(line + " --gauge A").out;
  EXPECT_NE(text.find("gauge A                   140.0                        0.998 of "
                      "kingery_bulmash\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(call(line + " --gauge a").err,
            "gauges.json: \"a\" is not a gauge of this run; choose one of \"lake\", \"A\", "
            "\"B\"\n");
  EXPECT_EQ(call(line + " --gauge B").err, "gauges.json: \"B\" has seen no pressure\n");
  write(path("other.json"), R"({"gauges": [1, 2]})");
  EXPECT_EQ(
      call("blast air --charge \"10 kg\" --distance \"5 m\" --gauges other.json --gauge A").err,
      "other.json: is no summary of gauges; name the gauges.json of a run\n");
  EXPECT_EQ(call(line).err, "moraine blast air: --gauge: is missing: which gauge of the run\n");
}

TEST_F(BlastCommand, ListsRelationsWithSources) {
  auto const all = nlohmann::json::parse(call("blast --list --json").out);
  EXPECT_EQ(all.size(), blast::relations().size());
  auto const crater = nlohmann::json::parse(call("blast crater --list --json").out);
  EXPECT_EQ(crater.size(), 6u);
  for (auto const& relation : crater) EXPECT_EQ(relation.at("topic"), "crater");
  EXPECT_NE(call("blast --list").out.find("ARBRL-TR-02555"), std::string::npos);
}

// A front that comes from a charge is that of the air around it.
TEST_F(BlastCommand, FrontsOfChargesKnowTheirAir) {
  std::string const place =
      " --charge \"10 kg\" --distance \"5 m\" --ambient-pressure \"70 kPa\" "
      "--ambient-density \"0.9 kg/m^3\"";
  auto const air = json("blast air" + place);
  auto const pulse = json("blast pulse --time \"0 s\"" + place);
  double const peak = value(air, "peak_overpressure", "kingery_bulmash");
  EXPECT_NEAR(value(pulse, "overpressure", "friedlander"), peak, 1e-9 * peak);
  double const impulse = value(air, "impulse", "kingery_bulmash");
  EXPECT_NEAR(value(pulse, "impulse", "friedlander"), impulse, 1e-9 * impulse);
  auto const wall = json("blast reflection" + place);
  double const reflected = value(air, "reflected_overpressure", "rankine_hugoniot");
  EXPECT_NEAR(value(wall, "reflected_overpressure", "normal"), reflected, 1e-9 * reflected);
}

TEST_F(BlastCommand, AnswersTellWhatTheyAssume) {
  CommandResult const result = call(
      "blast buried --charge \"1 kg\" --distance \"2 m\" --soil "
      "loam --coupling 1");
  EXPECT_NE(result.out.find("notes\n"), std::string::npos);
  EXPECT_NE(result.out.find("powers corrected to those of 2 I/p"), std::string::npos);
  EXPECT_EQ(
      json("blast surface --charge \"1 kg\" --distance \"2 m\"").at("estimates").at(0).at("note"),
      "hemispherical charge on rigid ground");
}

}  // namespace
}  // namespace moraine
