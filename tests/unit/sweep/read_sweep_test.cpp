#include "sweep/read_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "unit/output/scratch_folder.hpp"
#include "unit/sweep/sample_case.hpp"

namespace moraine {
namespace {

class ReadSweep : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    write(path("sample.toml"), sample_case);
  }
  SweepPlan plan(std::string const& text) const {
    write(path("sweep.toml"), "case = \"sample.toml\"\n" + text);
    return read_sweep(path("sweep.toml")).plan;
  }
  /// All messages, one a line, without the folder.
  std::string mistakes(std::string const& text) const {
    std::string said = message_of<InputErrors>([&] { plan(text); });
    std::string const folder = path("").string();
    for (auto at = said.find(folder); at != std::string::npos; at = said.find(folder))
      said.erase(at, folder.size());
    return said;
  }
  static std::vector<std::string> rows(SweepPlan const& plan) {
    std::vector<std::string> all;
    for (auto const& member : plan.members) {
      std::string& row = all.emplace_back();
      for (auto const& value : member.values) row += (row.empty() ? "" : " ") + value.toml;
    }
    return all;
  }
};

TEST_F(ReadSweep, GridTakesEveryValueWithEveryOther) {
  auto const read = plan(R"(method = "grid"
at_once = 3
[[parameter]]
key = "resolution.spacing"
values = ["1 cm", 0.02]
[[parameter]]
key = "resolution.kernel"
values = ["wendland_c2", "cubic_spline", "lucy"]
label = "kernel"
)");
  EXPECT_EQ(rows(read),
            (std::vector<std::string>{"\"1 cm\" \"wendland_c2\"", "\"1 cm\" \"cubic_spline\"",
                                      "\"1 cm\" \"lucy\"", "0.02 \"wendland_c2\"",
                                      "0.02 \"cubic_spline\"", "0.02 \"lucy\""}));
  EXPECT_EQ(read.members[0].name, "001-1_cm-wendland_c2");
  EXPECT_EQ(read.members[5].name, "006-0.02-lucy");
  EXPECT_EQ(std::get<double>(read.members[0].values[0].shown), 0.01);
  EXPECT_EQ(std::get<std::string>(read.members[0].values[1].shown), "wendland_c2");
  EXPECT_EQ(read.axes[0].columns[0].unit, "m");
  EXPECT_EQ(read.axes[1].columns[0].label, "kernel");
  EXPECT_EQ(read.at_once, 3);
}

TEST_F(ReadSweep, ListTakesValuesTogetherAndKeysMayGoTogether) {
  auto const read = plan(R"(method = "list"
[[parameter]]
keys = ["resolution.spacing", "resolution.smoothing_factor"]
values = [["1 cm", 1.2], ["2 cm", 1.5], ["2.5 cm", 2.0]]
label = ["spacing", "h over spacing"]
[[parameter]]
key = "time.end"
range = ["1 ms", "4 ms"]
steps = 3
scale = "log"
[[parameter]]
key = "gauge.1.5 cm.position"
values = [[0.1, 0.1]]
)");
  EXPECT_EQ(rows(read), (std::vector<std::string>{"\"1 cm\" 1.2 0.001 [0.1, 0.1]",
                                                  "\"2 cm\" 1.5 0.002 [0.1, 0.1]",
                                                  "\"2.5 cm\" 2.0 0.004 [0.1, 0.1]"}));
  EXPECT_EQ(read.columns()[1].label, "h over spacing");
  EXPECT_TRUE(read.axes[1].logarithmic);
  EXPECT_EQ(std::get<std::string>(read.members[0].values[3].shown), "[0.1, 0.1]");
}

TEST_F(ReadSweep, LatinHypercubeDrawsFromRangesAndValues) {
  std::string const text = R"(method = "latin_hypercube"
samples = 8
seed = 5
[[parameter]]
key = "material.gas.heat_capacity_ratio"
range = [1.2, 1.6]
[[parameter]]
key = "resolution.kernel"
values = ["wendland_c2", "cubic_spline"]
)";
  auto const read = plan(text);
  ASSERT_EQ(read.members.size(), 8U);
  std::vector<int> strata(8, 0);
  int first_kernel = 0;
  for (auto const& member : read.members) {
    double const value = std::get<double>(member.values[0].shown);
    ++strata[static_cast<std::size_t>((value - 1.2) / 0.4 * 8.0)];
    first_kernel += std::get<std::string>(member.values[1].shown) == "wendland_c2" ? 1 : 0;
  }
  EXPECT_EQ(strata, std::vector<int>(8, 1));
  EXPECT_EQ(first_kernel, 4) << "every value has its share";
  EXPECT_EQ(rows(plan(text)), rows(read));
}

TEST_F(ReadSweep, OutputsNameColumnsOfTheCase) {
  auto const read = plan(R"(method = "grid"
[[parameter]]
key = "resolution.spacing"
values = ["1 cm"]
[[output]]
gauge = "1.5 cm"
column = "pressure"
measure = "arrival"
[[output]]
gauge = "top"
measure = "largest"
label = "height"
[[output]]
sums = "total_energy"
measure = "last"
[[output]]
run = "energy_error"
)");
  ASSERT_EQ(read.outputs.size(), 4U);
  EXPECT_EQ(read.outputs[0].column, "1.5 cm pressure");
  EXPECT_EQ(read.outputs[0].label, "1.5 cm pressure arrival");
  EXPECT_EQ(read.outputs[0].unit, "s");
  EXPECT_EQ(read.outputs[1].column, "top front");
  EXPECT_EQ(read.outputs[1].label, "height");
  EXPECT_EQ(read.outputs[2].unit, "J");
  EXPECT_EQ(read.outputs[3].unit, "");
}

TEST_F(ReadSweep, AllMistakesAtOnceWithTheirPlaces) {
  EXPECT_EQ(
      mistakes(R"(method = "gird"
colour = "red"
[[parameter]]
key = "resolution.spacin"
values = [1]
[[parameter]]
key = "time.end"
values = ["3 kg", "1 ms", -1.0]
[[parameter]]
key = "resolution.kernel"
range = [1, 2]
steps = 3
[[output]]
gauge = "1.6 cm"
measure = "largest"
[[output]]
gauge = "top"
measure = "arrival"
[[output]]
sums = "total_energi"
measure = "last"
[[output]]
run = "steps"
measure = "last"
)"),
      "sweep.toml:2:10: method: \"gird\" is not a known name; did you mean \"grid\"?\n"
      "sweep.toml:3:1: colour: is an unknown key\n"
      "sweep.toml:5:7: parameter[1].key: \"resolution.spacin\" is no key of a case; did you mean "
      "\"resolution.spacing\"?\n"
      "sweep.toml:9:11: time.end: \"3 kg\" is a mass; a time is expected (s)\n"
      "sweep.toml:9:27: time.end: -1.0 must be greater than 0 s\n"
      "sweep.toml:12:9: parameter[3].range: [1, 2] is a range, but resolution.kernel takes no "
      "numbers; give values\n"
      "sweep.toml:15:9: output[1].gauge: \"1.6 cm\" is no gauge of the case; did you mean \"1.5 "
      "cm\"?\n"
      "sweep.toml:19:11: output[2].measure: \"arrival\" is known of pressures of gauges only\n"
      "sweep.toml:21:8: output[3].sums: \"total_energi\" is no column of sums.csv; did you mean "
      "\"total_energy\"?\n"
      "sweep.toml:25:11: output[4].measure: \"last\" does not belong to a number of the run; "
      "leave it out");
}

TEST_F(ReadSweep, WholeNumbersOfARangeAreDifferent) {
  EXPECT_EQ(mistakes(R"(method = "grid"
[[parameter]]
key = "space.dimension"
range = [2, 3]
steps = 5
)"),
            "sweep.toml:5:9: parameter[1].range: [2, 3] gives 2 different values only, not 5; take "
            "fewer steps, or another range");
}

TEST_F(ReadSweep, MembersAreCheckedAndEachMistakeIsSaidOnce) {
  EXPECT_EQ(mistakes(R"(method = "grid"
[[parameter]]
key = "gauge.1.position"
values = [[0.4, 0.25], [7.0, 0.25]]
[[parameter]]
key = "resolution.smoothing_factor"
values = [1.2, 1.3, 1.4, 1.5]
)"),
            "sweep.toml:5:24: gauge.1.position: [7.0, 0.25] is outside the domain (members "
            "005-7.0_0.25-1.2, 006-7.0_0.25-1.3, 007-7.0_0.25-1.4 and 1 more)");
  // A value that makes another key of the case wrong.
  EXPECT_EQ(
      mistakes(R"(method = "grid"
[[parameter]]
keys = ["space.domain.min", "space.domain.max"]
values = [[[0.0, 0.0], [0.5, 0.5]], [[0.0, 0.0], [0.3, 0.5]]]
)"),
      "sweep.toml: region.sea.box.max: [0.5, 0.5] is outside the domain (member 002-0.0_0.0)\n"
      "sweep.toml: wall.tank.container.max: [0.5, 0.5] is outside the domain (member "
      "002-0.0_0.0)\n"
      "sweep.toml: gauge.1.position: [0.4, 0.25] is outside the domain (member 002-0.0_0.0)");
}

TEST_F(ReadSweep, RulesBetweenKeysOfASweep) {
  EXPECT_EQ(mistakes(R"(method = "latin_hypercube"
[[parameter]]
key = "time.end"
range = ["1 ms", "2 ms"]
steps = 4
)"),
            "sweep.toml:2:10: samples: is missing: how many members a latin hypercube has\n"
            "sweep.toml:3:1: parameter[1]: has steps; a latin hypercube draws as many values as it "
            "has samples");
  EXPECT_EQ(
      mistakes(R"(method = "list"
seed = 3
[[parameter]]
key = "time.end"
values = ["1 ms", "2 ms"]
[[parameter]]
key = "numerics.viscosity_alpha"
range = [0.0, 2.0]
scale = "log"
steps = 3
[[parameter]]
key = "time.end"
values = ["1 ms", "2 ms", "3 ms"]
[[parameter]]
key = "resolution.spacing"
range = ["1 cm", "2 cm"]
[[parameter]]
key = "resolution.smoothing_factor"
values = [1.2, 1.3, 1.4]
[[parameter]]
key = "resolution.kernel"
values = ["lucy"]
label = "resolution.smoothing_factor"
)"),
      "sweep.toml:3:8: seed: 3 belongs to method = \"latin_hypercube\"; leave it out\n"
      "sweep.toml:6:11: time.end: has 2 values where another parameter has 3; a list takes the "
      "first values together, then the second ones ...; one value counts for all\n"
      "sweep.toml:9:10: numerics.viscosity_alpha: 0.0 has no place on a logarithmic scale; it "
      "must be above 0\n"
      "sweep.toml:12:1: parameter[3]: varies time.end a second time\n"
      "sweep.toml:15:1: parameter[4]: needs steps: how many values its range gives\n"
      "sweep.toml:21:1: parameter[6]: has the label \"resolution.smoothing_factor\" of another; "
      "give it a label of its own");
}

TEST_F(ReadSweep, RangesOfSeveralKeysAreOfOneQuantity) {
  EXPECT_EQ(mistakes(R"(method = "grid"
[[parameter]]
keys = ["resolution.spacing", "resolution.smoothing_factor"]
range = ["1 cm", "2 cm"]
steps = 2
)"),
            "sweep.toml:5:9: parameter[1].range: [\"1 cm\", \"2 cm\"] is a range of a length for "
            "resolution.smoothing_factor too; give values");
  EXPECT_EQ(rows(plan(R"(method = "grid"
[[parameter]]
keys = ["numerics.viscosity_alpha", "numerics.viscosity_beta"]
range = [1, 2]
steps = 2
)")),
            (std::vector<std::string>{"1.0 1.0", "2.0 2.0"}));
}

TEST_F(ReadSweep, ACaseThatCannotBeReadIsOneMistake) {
  write(path("sweep.toml"), "case = \"none.toml\"\nmethod = \"grid\"\n");
  EXPECT_EQ(message_of<InputErrors>([&] { read_sweep(path("sweep.toml")); }),
            path("sweep.toml").string() + ":1:8: case: \"none.toml\" does not exist");
}

}  // namespace
}  // namespace moraine
