// Keys of gauges that measure shapes, formulas and planes: what comes back, what is refused.
#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

// Twelve lines before the keys of the gauge, which start in line 13.
std::string text_of(std::string const& gauge, std::string const& space,
                    std::string const& gravity) {
  return "space = { " + space + " }\n" + "physics.gravity = " + gravity + R"(
resolution.spacing = 0.1
time.end = 1
material.soil = { eos = "tait" }
material.gas = { eos = "tait" }
[[region]]
name = "ground"
material = "soil"
box = { min = [0, 0], max = [1, 1] }
[[gauge]]
name = "probe"
)" + gauge;
}

Case with(std::string const& gauge, std::string const& gravity = "[0, -10]") {
  return parse_case(
      text_of(gauge, "dimension = 2, domain = { min = [0, -1], max = [1, 2] }", gravity),
      "case.toml");
}

std::string message_of(std::string const& gauge, std::string const& gravity = "[0, -10]") {
  try {
    with(gauge, gravity);
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

class GoodMeasure : public testing::TestWithParam<char const*> {};

TEST_P(GoodMeasure, ComesBackFromTheUsedCase) {
  EXPECT_EQ(message_of(GetParam()), "no error");
  std::string const used = used_case(with(GetParam()));
  EXPECT_EQ(used_case(parse_case(used, "used.toml")), used);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, GoodMeasure,
    testing::Values(
        "kind = \"line\"\nline = { from = [0, 0], to = [1, 1], origin = [0, \"-5 cm\"] }\n",
        "kind = \"crater\"\nmaterials = [\"soil\"]\ncrater = { level = 1, center = [0.5, 1] }\n",
        "kind = \"crater\"\nmaterials = [\"soil\", \"gas\"]\nup = \"x-\"\n"
        "crater = { level = -0.5, center = [0, 0.5], radius = \"30 cm\", sectors = 8 }\n",
        "kind = \"deposit\"\nmaterials = [\"soil\"]\ndeposit = { base = 0, along = \"x+\" }\n",
        "kind = \"deposit\"\nmaterials = [\"soil\"]\ndeposit = { base = 0, origin = [0.5, 0] }\n",
        "kind = \"bubble\"\nmaterials = [\"gas\"]\n",
        "kind = \"bubble\"\nmaterials = [\"gas\"]\nwithin = { min = [0, 0], max = [1, 1] }\n",
        "kind = \"rise\"\n",
        "kind = \"rise\"\nmaterials = [\"soil\"]\nwithin = { min = [0.2, 0], max = [0.4, 2] }\n",
        "kind = \"expression\"\nformula = \"max(pressure, 0) * volume\"\nreduce = \"sum\"\n"
        "unit = \"J\"\n",
        "kind = \"expression\"\nformula = \"y\"\nreduce = \"mean\"\nweight = \"volume\"\n",
        "kind = \"plane\"\nplane = { min = [0, 0], max = [1, 1], step = \"5 cm\" }\n"));

struct Bad {
  char const* gauge;
  char const* message;
};

class BadMeasure : public testing::TestWithParam<Bad> {};

TEST_P(BadMeasure, GivesItsMessage) { EXPECT_EQ(message_of(GetParam().gauge), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadMeasure,
    testing::Values(
        Bad{"kind = \"line\"\nline = { from = [0, 0], to = [1, 0], points = 2, origin = [0.5, 1] "
            "}\n",
            "case.toml:14:59: gauge.probe.line.origin: [0.5, 1] is as far from one end of the line "
            "as from the other; choose another origin, or more points"},
        Bad{"kind = \"crater\"\nmaterials = [\"sol\"]\ncrater = { level = 1, center = [0.5, 1] }\n",
            "case.toml:14:13: gauge.probe.materials: [\"sol\"] holds \"sol\", which is not a "
            "material "
            "of this case; did you mean \"soil\"?"},
        Bad{"kind = \"crater\"\nmaterials = []\ncrater = { level = 1, center = [0.5, 1] }\n",
            "case.toml:14:13: gauge.probe.materials: [] is empty; name at least one material"},
        Bad{"kind = \"crater\"\nmaterials = [\"soil\"]\ncrater = { level = 3, center = [0.5, 1] "
            "}\n",
            "case.toml:15:20: gauge.probe.crater.level: 3 is outside the domain"},
        Bad{"kind = \"crater\"\nmaterials = [\"soil\"]\ncrater = { level = 1, center = [2, 1] }\n",
            "case.toml:15:32: gauge.probe.crater.center: [2, 1] is outside the domain"},
        Bad{"kind = \"deposit\"\nmaterials = [\"soil\"]\ndeposit = { base = 0 }\n",
            "case.toml:11:1: gauge.probe.deposit.origin: is missing: the run-out needs a "
            "direction, "
            "or a place to be counted from; give deposit.along or deposit.origin"},
        Bad{"kind = \"deposit\"\nmaterials = [\"soil\"]\ndeposit = { base = 0, along = \"y-\" }\n",
            "case.toml:15:31: gauge.probe.deposit.along: \"y-\" is vertical; heights are counted "
            "along y+; choose another axis"},
        Bad{"kind = \"bubble\"\nmaterials = [\"gas\"]\nwithin = { min = [0, 0], max = [0, 1] }\n",
            "case.toml:15:32: gauge.probe.within.max: [0, 1] must be greater than min along x"},
        Bad{"kind = \"rise\"\nwithin = { min = [2, 0], max = [3, 1] }\n",
            "case.toml:14:32: gauge.probe.within.max: [3, 1] makes a box outside the domain"},
        Bad{"kind = \"expression\"\nformula = \"2 * presure\"\nreduce = \"max\"\n",
            "case.toml:14:11: gauge.probe.formula: \"2 * presure\" has \"presure\" at position 5, "
            "which is no field of a particle and no function; did you mean \"pressure\"?"},
        Bad{"kind = \"expression\"\nformula = \"y\"\nreduce = \"max\"\nweight = \"mass\"\n",
            "case.toml:16:10: gauge.probe.weight: \"mass\" has no effect: only a mean has weights; "
            "leave it out"},
        Bad{"kind = \"expression\"\nformula = \"y\"\nreduce = \"maxi\"\n",
            "case.toml:15:10: gauge.probe.reduce: \"maxi\" is not a known name; did you mean "
            "\"max\"?"},
        Bad{"kind = \"expression\"\nformula = \"y\"\nreduce = \"max\"\nunit = \"m, s\"\n",
            "case.toml:16:8: gauge.probe.unit: \"m, s\" cannot stand in the head of a table; leave "
            "out commas, brackets and quotes"},
        Bad{"kind = \"plane\"\nplane = { min = [0, 0], max = [1, 0], step = 0.1 }\n",
            "case.toml:14:31: gauge.probe.plane.max: [1, 0] must be greater than min along both "
            "axes"},
        Bad{"kind = \"plane\"\nplane = { min = [0, 0], max = [1, 3], step = 0.1 }\n",
            "case.toml:14:31: gauge.probe.plane.max: [1, 3] is outside the domain"},
        Bad{"kind = \"plane\"\nplane = { min = [0, 0], max = [1, 1], step = 1e-6 }\n",
            "case.toml:14:46: gauge.probe.plane.step: 1e-6 makes 1e+12 points; 1e+07 are possible"},
        Bad{"kind = \"rise\"\ncrater = { level = 1 }\n",
            "case.toml:14:1: gauge.probe.crater: is an unknown key"}));

TEST(BadMeasures, AFormulaHasItsPlace) {
  std::string const message =
      message_of("kind = \"expression\"\nformula = \"2 * (pressure\"\nreduce = \"max\"\n");
  EXPECT_NE(message.find("case.toml:14:11: gauge.probe.formula: \"2 * (pressure\" is no formula: "),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("position"), std::string::npos) << message;
}

TEST(BadMeasures, UnknownNamesFarFromAllListTheFields) {
  std::string const message =
      message_of("kind = \"expression\"\nformula = \"qqqqqqqq\"\nreduce = \"max\"\n");
  EXPECT_NE(message.find("fields are x, y, z, velocity_x"), std::string::npos) << message;
}

TEST(BadMeasures, ObliqueGravityNeedsADirection) {
  std::string const rise = "kind = \"rise\"\n";
  EXPECT_EQ(message_of(rise, "[1, -10]"),
            "case.toml:11:1: gauge.probe.up: is missing: gravity points along no axis; give up = "
            "\"y+\", for example");
  EXPECT_EQ(message_of(rise + "up = \"y+\"\n", "[1, -10]"), "no error");
}

/// The message of a gauge in a domain of another dimension, without gravity.
std::string message_in(int dimension, std::string const& gauge) {
  std::string const low = dimension == 1 ? "[0]" : "[0, 0, 0]";
  std::string const high = dimension == 1 ? "[1]" : "[1, 1, 1]";
  try {
    parse_case("space = { dimension = " + std::to_string(dimension) + ", domain = { min = " + low +
                   ", max = " + high + " } }\nresolution.spacing = 0.1\ntime.end = 1\n" +
                   "material.soil = { eos = \"tait\" }\n[[region]]\nname = \"a\"\n" +
                   "material = \"soil\"\nbox = { min = " + low + ", max = " + high + " }\n" +
                   "[[gauge]]\nname = \"probe\"\n" + gauge,
               "case.toml");
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

TEST(BadMeasures, PlanesAreFlatAlongOneAxisIn3D) {
  std::string const plane = "kind = \"plane\"\nplane = { min = [0, 0, 0], max = ";
  EXPECT_EQ(message_in(3, plane + "[1, 0, 1], step = 0.1 }\n"), "no error");
  EXPECT_EQ(message_in(3, plane + "[1, 1, 1], step = 0.1 }\n"),
            "case.toml:12:34: gauge.probe.plane.max: [1, 1, 1] agrees with min along 0 axes; it "
            "must along one");
  EXPECT_EQ(message_in(3, plane + "[1, 0, 0], step = 0.1 }\n"),
            "case.toml:12:34: gauge.probe.plane.max: [1, 0, 0] agrees with min along 2 axes; it "
            "must along one");
}

TEST(BadMeasures, OneDimensionHasNoCratersAndPlanes) {
  EXPECT_EQ(message_in(1,
                       "kind = \"crater\"\nmaterials = [\"soil\"]\n"
                       "crater = { level = 1, center = [0.5] }\n"),
            "case.toml:11:8: gauge.probe.kind: \"crater\" is a crater, which 1D does not have; "
            "compute in 2D or 3D");
  EXPECT_EQ(message_in(1, "kind = \"plane\"\nplane = { min = [0], max = [1], step = 0.1 }\n"),
            "case.toml:11:8: gauge.probe.kind: \"plane\" is a plane, which 1D does not have; "
            "compute in 2D or 3D");
}

TEST(BadMeasures, APlaneNamesFiles) {
  std::string text =
      text_of("kind = \"plane\"\nplane = { min = [0, 0], max = [1, 1], step = 0.1 }\n",
              "dimension = 2, domain = { min = [0, -1], max = [1, 2] }", "[0, -10]");
  text.replace(text.find("\"probe\""), 7, "\"a/b\"");
  try {
    parse_case(text, "case.toml");
    FAIL() << "a name with a slash";
  } catch (InputErrors const& errors) {
    EXPECT_STREQ(
        errors.what(),
        "case.toml:12:8: gauge.a/b.name: \"a/b\" names files and may hold letters, digits, "
        "- and _ only");
  }
}

}  // namespace
}  // namespace moraine
