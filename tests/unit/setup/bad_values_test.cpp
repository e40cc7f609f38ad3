// More mistakes, with the exact message: materials by name, units, retyped and misplaced values.
#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

constexpr std::string_view good_text = R"(title = "blast"
[space]
dimension = 2
[physics]
gravity = [0, "-1 g0"]
[resolution]
spacing = "1 cm"
[time]
end = "1 ms"
[output]
frames = "10 us"
[material.water]
use = "water_shock"
[material.tnt]
eos = "jwl"
[[region]]
name = "sea"
material = "water"
box = { min = [-1, -1], max = [1, 1] }
[[region]]
name = "charge"
material = "tnt"
disc = { center = [0, 0], radius = "5 cm" }
[[wall]]
name = "bed"
solid = { min = [-1, -1.5], max = [1, -1] }
[[gauge]]
name = "tip"
kind = "front"
material = "water"
)";

std::string message_of(std::string_view from, std::string_view to) {
  std::string text(good_text);
  auto const place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  try {
    parse_case(text.replace(place, from.size(), to), "case.toml");
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

TEST(BadValues, TheTextItselfIsGood) { EXPECT_EQ(message_of("1 cm", "1 cm"), "no error"); }

TEST(BadValues, StandardGravityIsUnderstood) {
  EXPECT_EQ(message_of("-1 g0", "-9.80665 m/s^2"), "no error");
}

struct Bad {
  char const* from;
  char const* to;
  char const* message;
};

class BadValue : public testing::TestWithParam<Bad> {};

TEST_P(BadValue, GivesItsMessage) {
  auto const& [from, to, message] = GetParam();
  EXPECT_EQ(message_of(from, to), message);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadValue,
    testing::Values(
        Bad{"use = \"water_shock\"", "use = \"watr_shock\"",
            "case.toml:13:7: material.water.use: \"watr_shock\" is not a known name; did you "
            "mean \"water_shock\"?"},
        Bad{"use = \"water_shock\"", "use = \"water_shock\"\neos = \"tait\"",
            "case.toml:14:7: material.water.eos: \"tait\" is given together with use; leave "
            "out one of the two"},
        Bad{"use = \"water_shock\"", "use = \"water_shock\"\nexponent = 7",
            "case.toml:14:1: material.water.exponent: does not belong to eos = "
            "\"water_polynomial\""},
        Bad{"use = \"water_shock\"", "use = \"water_shock\"\na1 = \"2 g/cm^3\"",
            "case.toml:14:6: material.water.a1: \"2 g/cm^3\" is a density; a pressure is "
            "expected (Pa)"},
        Bad{"use = \"water_shock\"", "",
            "case.toml:12:1: material.water.eos: is missing: equation of state; or give use"},
        Bad{"use = \"water_shock\"", "use = 7",
            "case.toml:13:7: material.water.use: 7 is an integer; a text is expected"},
        Bad{"eos = \"jwl\"", "eos = \"jlw\"",
            "case.toml:15:7: material.tnt.eos: \"jlw\" is not a known name; did you mean "
            "\"jwl\"?"},
        Bad{"eos = \"jwl\"", "eos = \"jwl\"\ndensity = 1630",
            "case.toml:16:1: material.tnt.density: is an unknown key; did you mean "
            "\"reference_density\"?"},
        Bad{"eos = \"jwl\"", "eos = \"jwl\"\nomega = 0",
            "case.toml:16:9: material.tnt.omega: 0 must be greater than 0"},
        Bad{"eos = \"jwl\"", "eos = \"jwl\"\na = \"371.2 GJ\"",
            "case.toml:16:5: material.tnt.a: \"371.2 GJ\" has another dimension; a pressure "
            "is expected (Pa)"},
        Bad{"eos = \"jwl\"", "eos = \"jwl\"\nreference_energy = \"4.29 MJ\"",
            "case.toml:16:20: material.tnt.reference_energy: \"4.29 MJ\" has another "
            "dimension; a specific energy is expected (J/kg)"},
        Bad{"eos = \"jwl\"", "eos = \"jwl\"\ndetonation_velocity = \"6930\"",
            "case.toml:16:23: material.tnt.detonation_velocity: \"6930\" is a plain number; "
            "a velocity is expected (m/s); write 6930 without quotes for SI, or \"6930 m/s\""},
        Bad{"\"-1 g0\"", "\"-1 g\"",
            "case.toml:5:15: physics.gravity: \"-1 g\" is a mass; an acceleration is "
            "expected (m/s^2); g is gram; did you mean \"-1 g0\" (standard gravity)?"},
        Bad{"\"-1 g0\"", "\"90 deg\"",
            "case.toml:5:15: physics.gravity: \"90 deg\" is an angle; an acceleration is "
            "expected (m/s^2)"},
        Bad{"spacing = \"1 cm\"", "spacing = \"1 deg\"",
            "case.toml:7:11: resolution.spacing: \"1 deg\" is an angle; a length is expected "
            "(m)"},
        Bad{"spacing = \"1 cm\"", "spacing = \"1 cmm\"",
            "case.toml:7:11: resolution.spacing: \"1 cmm\" has an unknown unit \"cmm\"; a "
            "length is expected (m); did you mean \"cm\"?"},
        Bad{"spacing = \"1 cm\"", "spacing = \"1,5 cm\"",
            "case.toml:7:11: resolution.spacing: \"1,5 cm\" is not a number and a unit; a "
            "length is expected (m)"},
        Bad{"spacing = \"1 cm\"", "spacing = \"-1 cm\"",
            "case.toml:7:11: resolution.spacing: \"-1 cm\" must be greater than 0 m"},
        Bad{"spacing = \"1 cm\"", "spacing = 0.01\nkernel = \"cubic_splin\"",
            "case.toml:8:10: resolution.kernel: \"cubic_splin\" is not a known name; did you "
            "mean \"cubic_spline\"?"},
        Bad{"spacing = \"1 cm\"", "spacing = 0.01\nsmoothing_factor = \"1.2 m\"",
            "case.toml:8:20: resolution.smoothing_factor: \"1.2 m\" is a length; a plain "
            "number is expected"},
        Bad{"spacing = \"1 cm\"", "spacing = { value = 1 }",
            "case.toml:7:11: resolution.spacing: { value = 1 } is a table; a length (m) is "
            "expected"},
        Bad{"dimension = 2", "dimension = 0",
            "case.toml:3:13: space.dimension: 0 must be between 1 and 3"},
        Bad{"dimension = 2", "dimension = \"2\"",
            "case.toml:3:13: space.dimension: \"2\" is a text; an integer is expected"},
        Bad{"dimension = 2", "dimension = 2\nperiodic = \"x\"",
            "case.toml:4:12: space.periodic: \"x\" is a text; a list of texts is expected"},
        Bad{"dimension = 2", "dimension = 2\ndomain = 3",
            "case.toml:4:10: space.domain: 3 must be a table"},
        Bad{"frames = \"10 us\"", "frames = \"-10 us\"",
            "case.toml:11:10: output.frames: \"-10 us\" must be at least 0 s"},
        Bad{"frames = \"10 us\"", "frame_times = [1, \"2 m\"]",
            "case.toml:11:19: output.frame_times: \"2 m\" is a length; a time is expected (s)"},
        Bad{"frames = \"10 us\"", "frame = \"10 us\"",
            "case.toml:11:1: output.frame: is an unknown key; did you mean \"frames\"?"},
        Bad{"end = \"1 ms\"", "end = \"1 ms\"\nmax_step = \"0 s\"",
            "case.toml:10:12: time.max_step: \"0 s\" must be greater than 0 s"},
        Bad{"end = \"1 ms\"", "end = \"1 Ms/s\"",
            "case.toml:9:7: time.end: \"1 Ms/s\" is a plain number; a time is expected (s)"},
        Bad{"radius = \"5 cm\"", "radius = \"0 cm\"",
            "case.toml:23:36: region.charge.disc.radius: \"0 cm\" must be greater than 0 m"},
        Bad{"radius = \"5 cm\"", "raduis = \"5 cm\"",
            "case.toml:23:8: region.charge.disc.radius: is missing: radius\n"
            "case.toml:23:27: region.charge.disc.raduis: is an unknown key; did you mean "
            "\"radius\"?"},
        Bad{"solid = {", "solid = 3 #", "case.toml:26:9: wall.bed.solid: 3 must be a table"},
        Bad{"name = \"bed\"", "name = \"bed\"\nslip = \"full\"",
            "case.toml:26:8: wall.bed.slip: \"full\" is not a known name; choose one of "
            "\"free\", \"none\""},
        Bad{"name = \"bed\"", "name = \"bed\"\nopen = \"y+\"",
            "case.toml:26:8: wall.bed.open: \"y+\" is a text; a list of texts is expected"},
        Bad{"kind = \"front\"", "kind = \"frnt\"",
            "case.toml:29:8: gauge.tip.kind: \"frnt\" is not a known name; did you mean "
            "\"front\"?"},
        Bad{"kind = \"front\"", "kind = \"front\"\naxis = \"z+\"",
            "case.toml:30:8: gauge.tip.axis: \"z+\" is not a side; choose one of \"x-\", \"x+\", "
            "\"y-\", \"y+\""},
        Bad{"kind = \"front\"\nmaterial = \"water\"", "kind = \"front\"",
            "case.toml:27:1: gauge.tip.material: is missing: name of a material"},
        Bad{"material = \"tnt\"", "material = 3",
            "case.toml:22:12: region.charge.material: 3 is an integer; a text is expected"},
        Bad{"material = \"tnt\"", "material = \"tnt\"\nvelocity = [\"1 m/s\", \"2 m\"]",
            "case.toml:23:22: region.charge.velocity: \"2 m\" is a length; a velocity is "
            "expected (m/s)"},
        Bad{"material = \"tnt\"", "material = \"tnt\"\npressure = \"1 kg/m^3\"",
            "case.toml:23:12: region.charge.pressure: \"1 kg/m^3\" is a density; a pressure "
            "is expected (Pa)"},
        Bad{"[material.tnt]\n", "[material]\ntnt = 3\n[material.other]\n",
            "case.toml:15:7: material.tnt: is not a table of this kind; write "
            "[material.NAME]\n"
            "case.toml:24:12: region.charge.material: \"tnt\" is not a material of this "
            "case; choose one of \"water\", \"other\""},
        Bad{"title = \"blast\"", "title = [\"blast\"]",
            "case.toml:1:9: title: [\"blast\"] is a list; a text is expected"}));

}  // namespace
}  // namespace moraine
