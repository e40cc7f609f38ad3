// `moraine check`, `explain`, `materials`, `new`, `schema`: what they print, leave and return.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "end_to_end/small_case.hpp"
#include "setup/build_model.hpp"
#include "setup/explain.hpp"
#include "setup/json_schema.hpp"
#include "setup/read_case.hpp"
#include "setup/starters.hpp"
#include "step/simulation.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class CaseCommands : public ScratchFolder {
 protected:
  CommandResult call(std::vector<std::string> const& arguments) {
    return moraine_command(path(""), arguments);
  }

  /// Names of what lies in the folder, without what the tests themselves put there.
  std::vector<std::string> left_behind() const {
    std::vector<std::string> names;
    for (auto const& entry : std::filesystem::directory_iterator(path("")))
      names.push_back(entry.path().filename());
    std::erase_if(names, [](std::string const& name) {
      return name == "out" || name == "err" || name == "case.toml";
    });
    return names;
  }
};

constexpr char const* two_mistakes =
    "case.toml:1:1: titel: is an unknown key; did you mean \"title\"?\n"
    "case.toml:4:26: resolution.spacing: \"2 s\" is a time; a length is expected (m)\n";

std::string bad_case() {
  std::string text = small_case("end = 0.02", "\"2 s\"");
  return text.replace(text.find("title"), 5, "titel");
}

TEST_F(CaseCommands, MistakesAreToldAndNothingIsWritten) {
  write(path("case.toml"), bad_case());
  for (auto const* command : {"run", "check"}) {
    CommandResult const result = call({command, "case.toml"});
    EXPECT_EQ(result.code, 2) << command;
    EXPECT_EQ(result.err, two_mistakes) << command;
    EXPECT_EQ(result.out, "") << command;
    EXPECT_EQ(left_behind(), std::vector<std::string>{}) << command;
    EXPECT_TRUE(std::filesystem::is_regular_file(path("out"))) << "not a folder of results";
  }
}

TEST_F(CaseCommands, CheckWritesMistakesAsJson) {
  write(path("case.toml"), bad_case());
  CommandResult const result = call({"check", "case.toml", "--json"});
  EXPECT_EQ(result.code, 2);
  auto const mistakes = nlohmann::json::parse(result.out).at("mistakes");
  ASSERT_EQ(mistakes.size(), 2u);
  EXPECT_EQ(mistakes[1].at("line"), 4);
  EXPECT_EQ(mistakes[1].at("column"), 26);
  EXPECT_EQ(mistakes[1].at("key"), "resolution.spacing");
}

TEST_F(CaseCommands, CheckTellsSizeAndCost) {
  write(path("case.toml"), small_case());
  CommandResult const text = call({"check", "case.toml"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("150 of water"), std::string::npos) << text.out;
  CommandResult const result = call({"check", "case.toml", "--json"});
  EXPECT_EQ(result.code, 0);
  auto const json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("mistakes").size(), 0u);
  EXPECT_EQ(json.at("fluid_particles").at("water"), 150);
  EXPECT_GT(json.at("wall_particles"), 0);
  double const step = json.at("time_step_s");
  EXPECT_GT(step, 0.0);
  EXPECT_EQ(json.at("estimated_steps"), std::ceil(0.02 / step));
  double const per_step = json.at("seconds_per_step");
  EXPECT_GT(per_step, 0.0);
  EXPECT_DOUBLE_EQ(json.at("estimated_wall_time_s"),
                   per_step * json.at("estimated_steps").get<double>());
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

TEST_F(CaseCommands, StartersRunAsTheyAre) {
  ASSERT_EQ(starter_texts().size(), 4u);
  for (auto const& [kind, text] : starter_texts()) {
    std::string const file = std::string(kind) + ".toml";
    CommandResult const made = call({"new", std::string(kind)});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(bytes_of(path(file)), text);
    CommandResult const check = call({"check", file, "--json"});
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_EQ(nlohmann::json::parse(check.out).at("warnings").size(), 0u) << check.out;
    Simulation simulation(build_model(parse_case(text, file)));
    for (int k = 0; k < 5; ++k) simulation.advance();
    EXPECT_EQ(simulation.step(), 5u) << kind;
  }
}

TEST_F(CaseCommands, NewOverwritesNothing) {
  write(path("tank.toml"), "mine");
  CommandResult const result = call({"new", "tank"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "moraine new: \"tank.toml\" exists and is not overwritten; name another file\n");
  EXPECT_EQ(bytes_of(path("tank.toml")), "mine");
  CommandResult const unknown = call({"new", "dam-brake"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.err,
            "moraine new: \"dam-brake\" is no kind of starter case; did you mean \"dam-break\"?\n");
  EXPECT_EQ(call({"new", "tank", "nowhere/tank.toml"}).code, 2);
}

TEST_F(CaseCommands, ExplainAndSchemaAndMaterialsPrint) {
  EXPECT_EQ(call({"explain", "resolution.spacing"}).out, explain("resolution.spacing"));
  EXPECT_EQ(call({"explain"}).out, explain(""));
  EXPECT_EQ(call({"explain", "--reference"}).out, reference_page());
  EXPECT_EQ(call({"explain", "resolution.spacng"}).code, 2);
  EXPECT_EQ(call({"schema"}).out, json_schema());
  EXPECT_NE(call({"materials"}).out.find("tnt"), std::string::npos);
  EXPECT_NE(call({"materials", "tnt"}).out.find("6930 m/s"), std::string::npos);
  EXPECT_EQ(call({"materials", "tnd"}).code, 2);
  write(path("case.toml"), small_case());
  CommandResult const step = call({"explain", "--step", "case.toml"});
  EXPECT_EQ(step.code, 0);
  EXPECT_NE(step.out.find(". time step: "), std::string::npos) << step.out;
}

}  // namespace
}  // namespace moraine
