// `moraine plot`, `verify`, `bench`, `--help`: what they print and their exit codes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "end_to_end/small_case.hpp"
#include "support/places.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"
#include "verify/check.hpp"

namespace moraine {
namespace {

class Commands : public ScratchFolder {
 protected:
  CommandResult call(std::vector<std::string> const& arguments) {
    return moraine_command(path(""), arguments);
  }
};

TEST_F(Commands, PlotDrawsARun) {
  write(path("case.toml"), small_case());
  ASSERT_EQ(call({"run", "case.toml", "-o", "result"}).code, 0);
  CommandResult const result = call({"plot", "result", "--field", "velocity"});
  ASSERT_EQ(result.code, 0) << result.err;
  std::istringstream lines(result.out);
  int pictures = 0;
  for (std::string line; std::getline(lines, line); ++pictures) {
    std::string const bytes = bytes_of(path(line));
    if (line.ends_with(".png"))
      EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n") << line;
    else
      EXPECT_NE(bytes.find("<svg"), std::string::npos) << line;
    EXPECT_GT(bytes.size(), 1000u) << line;
  }
  EXPECT_EQ(pictures, 9) << "two tables in two formats, five frames\n" << result.out;
  EXPECT_NE(result.out.find("velocity_particles_000005.png"), std::string::npos) << "the last one";
}

TEST_F(Commands, PlotFailsWithoutARun) {
  CommandResult const result = call({"plot", "nowhere"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("nowhere"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("nowhere")));
}

TEST_F(Commands, VerifyListsItsChecks) {
  CommandResult const result = call({"verify", "--list"});
  EXPECT_EQ(result.code, 0);
  for (Check const& check : checks()) {
    EXPECT_NE(result.out.find(check.name), std::string::npos);
    EXPECT_NE(result.out.find(check.requirement), std::string::npos);
  }
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'),
            static_cast<std::ptrdiff_t>(checks().size()));
}

TEST_F(Commands, VerifyRunsChecksByName) {
  CommandResult const result = call({"verify", "momentum-double", "--quick"});
  EXPECT_EQ(result.code, 0) << result.out;
  EXPECT_NE(result.out.find("pass  momentum-double"), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find("momentum-mixed"), std::string::npos);
  EXPECT_EQ(result.out.find('\033'), std::string::npos) << "no colours in a file";
  CommandResult const unknown = call({"verify", "momentum-dobule"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("momentum-double"), std::string::npos) << "the nearest name";
}

TEST_F(Commands, VerifyWritesJson) {
  CommandResult const result = call({"verify", "momentum-double", "--quick", "--json"});
  EXPECT_EQ(result.code, 0);
  auto const json = nlohmann::json::parse(result.out);
  ASSERT_GE(json.size(), 1u);
  for (auto const& one : json) {
    EXPECT_EQ(one.at("name").get<std::string>().rfind("momentum-double", 0), 0u);
    double const measured = one.at("measured");
    EXPECT_LE(std::fabs(measured - one.at("reference").get<double>()),
              one.at("tolerance").get<double>());
    EXPECT_TRUE(one.at("unit").is_string());
    EXPECT_EQ(one.at("pass"), true);
  }
}

TEST_F(Commands, BenchWritesJson) {
  CommandResult const result = call(
      {"bench", "dam-break-3d-1e4", "--json", "--steps", "4", "--warm-up", "1", "--threads", "2"});
  ASSERT_EQ(result.code, 0) << result.err;
  auto const json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("machine").at("threads"), 2);
  ASSERT_EQ(json.at("workloads").size(), 1u);
  auto const& measured = json.at("workloads")[0];
  EXPECT_EQ(measured.at("name"), "dam-break-3d-1e4");
  EXPECT_EQ(measured.at("particles"), 9900);
  EXPECT_EQ(measured.at("threads"), 2);
  EXPECT_EQ(measured.at("steps"), 4);
  double const neighbours = measured.at("neighbours");
  EXPECT_GT(neighbours, 120.0) << "163 inside, fewer at the surface";
  EXPECT_LT(neighbours, 175.0);
  // The figures belong together: pairs = particles * neighbours * steps.
  double const seconds = measured.at("wall_seconds");
  EXPECT_GT(seconds, 0.0);
  double const particle_steps = measured.at("particle_steps_per_second");
  EXPECT_NEAR(particle_steps * seconds, 9900.0 * 4.0, 1.0);
  double const per_core = measured.at("neighbour_interactions_per_second_per_core");
  EXPECT_NEAR(per_core * 2.0 * seconds, 9900.0 * 4.0 * neighbours, 0.1 * 9900.0 * 4.0 * neighbours)
      << "pairs of all steps on two threads";
  double const bytes = measured.at("bytes_per_particle");
  EXPECT_GT(bytes, 8.0 * 10.0) << "the state alone";
  EXPECT_LT(bytes, 1e5);
}

TEST_F(Commands, BenchTakesACaseFile) {
  std::string const file = source_folder() + "/cases/sod/case.toml";
  CommandResult const result = call({"bench", file, "--json", "--steps", "2", "--warm-up", "0"});
  ASSERT_EQ(result.code, 0) << result.err;
  auto const json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("workloads")[0].at("name"), file);
  EXPECT_EQ(json.at("workloads")[0].at("steps"), 2);
  EXPECT_EQ(call({"bench", "none.toml"}).code, 2);
}

TEST_F(Commands, BenchListsAndRefuses) {
  CommandResult const list = call({"bench", "--list"});
  EXPECT_EQ(list.code, 0);
  EXPECT_NE(list.out.find("dam-break-3d"), std::string::npos);
  CommandResult const unknown = call({"bench", "dam-brake-3d"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("dam-break-3d"), std::string::npos);
}

TEST_F(Commands, AllHaveHelp) {
  CommandResult const all = call({"--help"});
  EXPECT_EQ(all.code, 0);
  std::vector<std::pair<std::string, std::vector<std::string>>> const commands{
      {"run", {"case", "--output", "--threads"}},
      {"plot", {"folder", "--field"}},
      {"verify", {"--list", "--quick", "--json", "--threads"}},
      {"bench", {"--list", "--json", "--steps", "--warm-up", "--threads"}}};
  for (auto const& [command, options] : commands) {
    EXPECT_NE(all.out.find(command), std::string::npos) << command;
    CommandResult const help = call({command, "--help"});
    EXPECT_EQ(help.code, 0) << command;
    for (std::string const& option : options)
      EXPECT_NE(help.out.find(option), std::string::npos) << command << ' ' << option;
  }
  CommandResult const version = call({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_FALSE(version.out.empty());
}

TEST_F(Commands, RefuseWhatTheyDoNotKnow) {
  for (std::vector<std::string> const& arguments : {std::vector<std::string>{},
                                                    {"fly"},
                                                    {"run"},
                                                    {"run", "case.toml", "--speed", "9"},
                                                    {"bench", "--steps", "0"},
                                                    {"verify", "--threads", "-1"}}) {
    CommandResult const result = call(arguments);
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_FALSE(result.err.empty());
  }
}

}  // namespace
}  // namespace moraine
