// Keys of gauges: what is accepted comes back from the used case, what is wrong has its message.
#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

// Ten lines before the gauge, which starts in line 11.
constexpr std::string_view start =
    R"(space = { dimension = 2, periodic = ["x"], domain = { min = [0, -1], max = [1, 2] } }
resolution.spacing = 0.1
time.end = 1
material.water = { eos = "tait" }
[[region]]
name = "pool"
material = "water"
box = { min = [0, 0], max = [1, 1] }
[[wall]]
name = "floor"
container = { min = [0, 0], max = [1, 1] }
open = ["y+"]
[[gauge]]
name = "probe"
)";

Case with(std::string const& gauge) { return parse_case(std::string(start) + gauge, "case.toml"); }

std::string message_of(std::string const& gauge) {
  try {
    build_model(with(gauge));
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

class GoodProbe : public testing::TestWithParam<char const*> {};

TEST_P(GoodProbe, ComesBackFromTheUsedCase) {
  EXPECT_EQ(message_of(GetParam()), "no error");
  std::string const used = used_case(with(GetParam()));
  EXPECT_EQ(used_case(parse_case(used, "used.toml")), used);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, GoodProbe,
    testing::Values("kind = \"wall\"\nwall = \"floor\"\n",
                    "kind = \"wall\"\nwall = \"floor\"\nabout = [\"5 cm\", 0]\n"
                    "part = { min = [0.2, -0.1], max = [0.4, 0.1] }\n",
                    "kind = \"line\"\nline = { from = [0, 0], to = [1, 1], points = 3 }\n",
                    "kind = \"level\"\nlevel = { from = [0.5, 0], to = [0.5, 2] }\n",
                    "kind = \"sums\"\nof = \"water\"\n", "kind = \"side\"\nside = \"y+\"\n",
                    "kind = \"budget\"\n"));

TEST(GoodProbe, ArrivalPressureIsAnOptionOfTheOutput) {
  std::string const text =
      "output.arrival_pressure = \"1 bar\"\n" + std::string(start) + "kind = \"budget\"\n";
  Case const c = parse_case(text, "case.toml");
  EXPECT_EQ(c.output.arrival_pressure, 1e5);
  EXPECT_EQ(parse_case(used_case(c), "used.toml").output.arrival_pressure, 1e5);
}

struct Bad {
  char const* gauge;
  char const* message;
};

class BadProbe : public testing::TestWithParam<Bad> {};

TEST_P(BadProbe, GivesItsMessage) { EXPECT_EQ(message_of(GetParam().gauge), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadProbe,
    testing::Values(
        Bad{"kind = \"wall\"\nwall = \"flor\"\n",
            "case.toml:16:8: gauge.probe.wall: \"flor\" is not a wall of this case; did you mean "
            "\"floor\"?"},
        Bad{"kind = \"wall\"\n",
            "case.toml:13:1: gauge.probe.wall: is missing: name of the wall whose load is "
            "measured"},
        Bad{"kind = \"wall\"\nwall = \"floor\"\npart = { min = [0, 0] }\n",
            "case.toml:17:8: gauge.probe.part.max: is missing: upper corner of that box"},
        Bad{"kind = \"wall\"\nwall = \"floor\"\npart = { min = [0, 0], max = [0, 1] }\n",
            "case.toml:17:30: gauge.probe.part.max: [0, 1] must be greater than min along x"},
        Bad{"kind = \"wall\"\nwall = \"floor\"\npart = { min = [0, 0.5], max = [1, 1] }\n",
            "case.toml:17:16: gauge.probe.part.min: [0, 0.5] makes a box without any place of the "
            "faces of wall \"floor\""},
        Bad{"kind = \"line\"\nline = { from = [0, 0], to = [0, 0] }\n",
            "case.toml:16:30: gauge.probe.line.to: [0, 0] is the place where the line begins"},
        Bad{"kind = \"line\"\nline = { from = [0, 0], to = [0, 3] }\n",
            "case.toml:16:30: gauge.probe.line.to: [0, 3] is outside the domain"},
        Bad{"kind = \"line\"\nline = { from = [0, 0], to = [0, 1], points = 1 }\n",
            "case.toml:16:47: gauge.probe.line.points: 1 must be between 2 and 1000"},
        Bad{"kind = \"level\"\nlevel = { from = [0, 0], to = [0, -2] }\n",
            "case.toml:16:31: gauge.probe.level.to: [0, -2] is outside the domain"},
        Bad{"kind = \"sums\"\nof = \"watr\"\n",
            "case.toml:16:6: gauge.probe.of: \"watr\" is not a material of this case; did you "
            "mean \"water\"?"},
        Bad{"kind = \"side\"\nside = \"x+\"\n",
            "case.toml:16:8: gauge.probe.side: \"x+\" is a side that nothing leaves through: the "
            "domain repeats itself along x"},
        Bad{"kind = \"budget\"\nside = \"x+\"\n",
            "case.toml:16:1: gauge.probe.side: does not belong to kind = \"budget\""},
        Bad{"kind = \"budgt\"\n",
            "case.toml:15:8: gauge.probe.kind: \"budgt\" is not a known name; did you mean "
            "\"budget\"?"}));

}  // namespace
}  // namespace moraine
