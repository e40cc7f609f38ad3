// `moraine exact`: numbers, tables, pictures, messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "output/table_csv.hpp"
#include "support/program.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class Exact : public ScratchFolder {
 protected:
  CommandResult call(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "exact");
    return moraine_command(path(""), arguments);
  }

  std::vector<std::string> names() {
    std::vector<std::string> list;
    std::istringstream lines(call({}).out);
    for (std::string line; std::getline(lines, line) && !line.empty();)
      list.push_back(line.substr(0, line.find(' ')));
    return list;
  }

  nlohmann::json solved(std::vector<std::string> arguments) {
    arguments.push_back("--json");
    CommandResult const result = call(arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }
};

double number(nlohmann::json const& answer, std::string const& name) {
  for (auto const& one : answer.at("numbers"))
    if (one.at("name") == name) return one.at("value");
  ADD_FAILURE() << name << " is not in the answer";
  return NAN;
}

// With its defaults every solution answers, says its source, and has a profile of finite numbers.
TEST_F(Exact, EverySolutionAnswersByItself) {
  auto const list = names();
  EXPECT_EQ(list.size(), 17u);
  for (char const* name :
       {"sod", "toro-5", "noh", "sedov", "riemann", "hugoniot", "cj", "taylor-wave", "slab",
        "couette", "poiseuille", "taylor-green", "standing-wave"})
    EXPECT_EQ(std::count(list.begin(), list.end(), name), 1) << name;
  for (std::string const& name : list) {
    auto const answer = solved({name, "--points", "20"});
    EXPECT_FALSE(answer.at("source").get<std::string>().empty());
    EXPECT_GE(answer.at("numbers").size(), 3u) << name;
    for (auto const& one : answer.at("numbers")) EXPECT_TRUE(one.at("value").is_number()) << name;
    EXPECT_GE(answer.at("profile").size(), 3u) << name;
    for (auto const& column : answer.at("profile")) {
      EXPECT_EQ(column.at("values").size(), 20u) << name;
      for (auto const& value : column.at("values"))
        EXPECT_TRUE(value.is_number() && std::isfinite(value.get<double>())) << name;
    }
    CommandResult const text = call({name});
    EXPECT_NE(text.out.find("source: "), std::string::npos) << name;
    CommandResult const parameters = call({name, "--list"});
    EXPECT_EQ(parameters.code, 0);
    EXPECT_EQ(parameters.out.find(name + ": "), 0u);
  }
}

// Known figures: Toro's table 4.3, handbook values of TNT, 4 and 16 times the density.
TEST_F(Exact, NumbersAreThoseOfTheLiterature) {
  auto const toro = solved({"toro-4"});
  EXPECT_NEAR(number(toro, "pressure between the waves"), 46.0950, 5e-4);
  EXPECT_NEAR(number(toro, "velocity of the contact"), -6.19633, 5e-5);
  auto const noh = solved({"noh", "--parameters", "geometry=cylindrical"});
  EXPECT_NEAR(number(noh, "density behind the shock"), 16.0, 1e-12);
  auto const cj = solved({"cj", "--parameters", "explosive=tnt", "into=water_shock"});
  EXPECT_NEAR(number(cj, "detonation velocity"), 6930.0, 7.0);
  EXPECT_NEAR(number(cj, "C-J pressure"), 21.0e9, 0.05e9);
  EXPECT_NEAR(number(cj, "pressure at the interface"), 14.5e9, 0.05 * 14.5e9);
  // The same problem, once as Sod's tube and once as two materials.
  auto const sod = solved({"sod"});
  auto const gas =
      solved({"riemann", "--time", "0.2 s", "--parameters", "left=air", "left_density=1",
              "left_pressure=1", "right=air", "right_density=0.125", "right_pressure=0.1"});
  for (char const* name :
       {"pressure between the waves", "velocity of the contact", "density behind the right wave"})
    EXPECT_NEAR(number(gas, name), number(sod, name), 1e-12) << name;
}

TEST_F(Exact, UnitsAreRead) {
  auto const si = solved({"slab", "--parameters", "thickness=0.05", "--time", "5e-6"});
  auto const units = solved({"slab", "--parameters", "thickness=5 cm", "--time", "5 us"});
  EXPECT_EQ(si, units);
  EXPECT_EQ(si.at("parameters").at("thickness"), 0.05);
}

TEST_F(Exact, WritesTablesAndPictures) {
  CommandResult const result =
      call({"taylor-wave", "--points", "50", "--csv", "wave.csv", "--plot", "wave.svg"});
  ASSERT_EQ(result.code, 0) << result.err;
  Table const table = read_table_csv(path("wave.csv"));
  EXPECT_EQ(table.rows(), 50u);
  auto const printed = call({"taylor-wave", "--points", "50", "--csv", "-"});
  EXPECT_EQ(printed.out, bytes_of(path("wave.csv")));
  auto const json = solved({"taylor-wave", "--points", "50"});
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    EXPECT_EQ(json.at("profile")[k].at("name"), table.columns[k].name);
    EXPECT_EQ(json.at("profile")[k].at("unit"), table.columns[k].unit);
    EXPECT_EQ(json.at("profile")[k].at("values"), table.values[k]);
  }
  EXPECT_NE(bytes_of(path("wave.svg")).find("<svg"), std::string::npos);
  EXPECT_GT(bytes_of(path("wave.svg")).size(), 1000u);
}

TEST_F(Exact, TellsAllMistakesAtOnce) {
  CommandResult const result =
      call({"riemann", "--csv", "table.csv", "--time", "-1 s", "--parameters", "left=tnd",
            "right_velocty=3", "left_density=1 kg", "left_pressure=x", "right", "left=air"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "moraine exact: --time: \"-1 s\" must be positive\n"
            "moraine exact: left: \"tnd\" is no shipped material; did you mean \"tnt\"?\n"
            "moraine exact: --parameters: \"right_velocty\" is no parameter of riemann; did you "
            "mean \"right_velocity\"?\n"
            "moraine exact: left_density: \"1 kg\" is a mass; a density is expected (kg/m^3)\n"
            "moraine exact: left_pressure: \"x\" is not a number and a unit; a pressure is "
            "expected (Pa)\n"
            "moraine exact: --parameters: \"right\" is not of the form key=value\n"
            "moraine exact: --parameters: \"left=air\" gives a parameter twice\n");
  EXPECT_FALSE(std::filesystem::exists(path("table.csv")));
}

TEST_F(Exact, RefusesWhatHasNoSolution) {
  auto const refusal = [this](std::vector<std::string> const& arguments) {
    CommandResult const result = call(arguments);
    EXPECT_EQ(result.code, 2) << result.out;
    EXPECT_TRUE(result.out.empty());
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  };
  auto const has = [](std::string const& text, char const* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(refusal({"sodd"}), "did you mean \"sod\"?");
  has(refusal({"riemann", "--parameters", "left=water_shock", "right_velocity=100 m/s"}),
      "the liquid cavitates");
  has(refusal({"riemann", "--parameters", "left=air", "right=air", "right_velocity=5 km/s"}),
      "leave a vacuum");
  has(refusal({"slab", "--time", "1 s"}), "choose at most 2.45087e-05 s");
  has(refusal({"cj", "--parameters", "explosive=water"}), "is no shipped explosive");
  has(refusal({"hugoniot", "--time", "1 s"}), "has no time");
  has(refusal({"noh", "--parameters", "heat_capacity_ratio=0.5"}), "must be above 1");
  has(refusal({"sedov", "--parameters", "geometry=round"}), "\"planar\"");
  has(refusal({"sod", "--plot", "a.pdf"}), ".svg or .png");
  has(refusal({"riemann", "--parameters", "left=water", "left_density=2000", "left_pressure=1e5"}),
      "does not have it at this left_density");
}

}  // namespace
}  // namespace moraine
