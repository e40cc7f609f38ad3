// One mistake per rule, with the exact message.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "base/input_error.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

constexpr std::string_view good_text = R"(title = "test"
[space]
dimension = 2
domain = { min = [-1, -1], max = [2, 2] }
[physics]
gravity = [0, -9.81]
[resolution]
spacing = "1 cm"
[time]
end = "1 ms"
[material.water]
eos = "tait"
[[region]]
name = "pool"
material = "water"
box = { min = [0, 0], max = [1, 1] }
[[wall]]
name = "tank"
container = { min = [0, 0], max = [1, 1] }
[[gauge]]
name = "probe"
position = [0.5, 0.5]
)";

std::string replaced(std::string_view from, std::string_view to) {
  std::string text(good_text);
  auto const place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

std::string message_of(std::string_view text) {
  try {
    parse_case(text, "case.toml");
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

TEST(BadCases, TheTextItselfIsGood) { EXPECT_EQ(message_of(good_text), "no error"); }

struct Bad {
  char const* from;
  char const* to;
  char const* message;
};

class BadCase : public testing::TestWithParam<Bad> {};

TEST_P(BadCase, GivesItsMessage) {
  auto const& [from, to, message] = GetParam();
  EXPECT_EQ(message_of(replaced(from, to)), message);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadCase,
    testing::Values(
        Bad{"title =", "titel =",
            "case.toml:1:1: titel: is an unknown key; did you mean \"title\"?"},
        Bad{"spacing =", "spacing = 0.01\nsmoth =",
            "case.toml:9:1: resolution.smoth: is an unknown key"},
        Bad{"end =", "courant = 0.2\nspacing = 0.1\nend =",
            "case.toml:11:1: time.spacing: is an unknown key; "
            "did you mean \"resolution.spacing\"?"},
        Bad{"[space]", "[spaces]\na = 1\n[space]",
            "case.toml:2:2: spaces: is an unknown key; did you mean \"space\"?"},
        Bad{"end = \"1 ms\"", "", "case.toml:9:1: time.end: is missing: end of the simulation"},
        Bad{"[time]\nend = \"1 ms\"", "", "case.toml: time.end: is missing: end of the simulation"},
        Bad{"domain = { min = [-1, -1], max = [2, 2] }", "domain.min = [-1, -1]",
            "case.toml:4:1: space.domain.max: is missing: upper corner of the domain"},
        Bad{"name = \"pool\"", "",
            "case.toml:13:1: region[1].name: is missing: unique name, used in messages and "
            "output"},
        Bad{"eos = \"tait\"", "eos = \"tait\"\nr1 = 4",
            "case.toml:13:1: material.water.r1: does not belong to eos = \"tait\""},
        Bad{"eos = \"tait\"", "eos = \"tait\"\nsound_speed = 4",
            "case.toml:13:1: material.water.sound_speed: is an unknown key; did you mean "
            "\"reference_sound_speed\"?"},
        Bad{"position", "axis = \"x+\"\nposition",
            "case.toml:22:1: gauge.probe.axis: does not belong to kind = \"point\""},
        Bad{"box =", "shape = 1\nbox =", "case.toml:16:1: region.pool.shape: is an unknown key"},
        Bad{"[[wall]]", "[[walls]]",
            "case.toml:17:3: walls: is an unknown key; did you mean \"wall\"?"},
        Bad{"[[wall]]", "[wall]",
            "case.toml:17:1: wall: is not a table of this kind; write [[wall]]"},
        Bad{"[material.water]", "[[material]]",
            "case.toml:11:1: material: is not a table of this kind; write [material.NAME]\n"
            "case.toml:15:12: region.pool.material: \"water\" is not a material of this case"}));

INSTANTIATE_TEST_SUITE_P(
    Values, BadCase,
    testing::Values(
        Bad{"\"1 cm\"", "\"3 kg\"",
            "case.toml:8:11: resolution.spacing: \"3 kg\" is a mass; a length is expected (m)"},
        Bad{"\"1 cm\"", "true",
            "case.toml:8:11: resolution.spacing: true is a boolean; a length (m) is expected"},
        Bad{"\"1 cm\"", "0", "case.toml:8:11: resolution.spacing: 0 must be greater than 0 m"},
        Bad{"\"1 cm\"", "nan", "case.toml:8:11: resolution.spacing: nan is not a number"},
        Bad{"\"1 ms\"", "inf", "case.toml:10:7: time.end: inf must be finite"},
        Bad{"\"1 cm\"", "0.01\nsmoothing_factor = 0.7",
            "case.toml:9:20: resolution.smoothing_factor: 0.7 must be between 0.8 and 8"},
        Bad{"\"1 ms\"", "1\ncourant = 1.5",
            "case.toml:11:11: time.courant: 1.5 must be greater than 0, at most 1"},
        Bad{"\"1 cm\"", "0.01\nkernel = \"wendland\"",
            "case.toml:9:10: resolution.kernel: \"wendland\" is not a known name; "
            "did you mean \"wendland_c2\"?"},
        Bad{"eos = \"tait\"", "eos = \"steam\"",
            "case.toml:12:7: material.water.eos: \"steam\" is not a known name; choose one of "
            "\"tait\", \"water_polynomial\", \"jwl\", \"ideal_gas\", \"mie_grueneisen\", "
            "\"us_up\", "
            "\"linear\", \"p_alpha\""},
        Bad{"eos = \"tait\"", "eos = \"tait\"\nexponent = 0.5",
            "case.toml:13:12: material.water.exponent: 0.5 must be at least 1"},
        Bad{"-9.81", "\"0.35 g\"",
            "case.toml:6:15: physics.gravity: \"0.35 g\" is a mass; an acceleration is expected "
            "(m/s^2); g is gram; did you mean \"0.35 g0\" (standard gravity)?"},
        Bad{"[0, -9.81]", "[0, -9.81, 0]",
            "case.toml:6:11: physics.gravity: [0, -9.81, 0] has 3 components; 2 expected "
            "(space.dimension)"},
        Bad{"[0, -9.81]", "-9.81",
            "case.toml:6:11: physics.gravity: -9.81 is a number with decimals; a vector, each "
            "component an acceleration (m/s^2), is expected"},
        Bad{"dimension = 2", "dimension = 4",
            "case.toml:3:13: space.dimension: 4 must be between 1 and 3"},
        Bad{"dimension = 2", "dimension = 2.0",
            "case.toml:3:13: space.dimension: 2.0 is a number with decimals; an integer is "
            "expected"},
        Bad{"domain =", "periodic = [\"z\"]\ndomain =",
            "case.toml:4:13: space.periodic: \"z\" is not an axis; choose one of \"x\", \"y\""},
        Bad{"name = \"tank\"", "name = \"tank\"\nopen = [\"up\"]",
            "case.toml:19:9: wall.tank.open: \"up\" is not a side; choose one of \"x-\", \"x+\", "
            "\"y-\", \"y+\""},
        Bad{"name = \"pool\"", "name = \"\"",
            "case.toml:14:8: region[1].name: \"\" must not be empty"},
        Bad{"title = \"test\"", "title = 1979-05-27",
            "case.toml:1:9: title: 1979-05-27 is a date or time; a text is expected"},
        Bad{"[space]", "title = \"again\"\n[space]",
            "case.toml:2:9: Error while parsing key-value pair: cannot redefine existing string "
            "'title'"},
        Bad{"[[wall]]", "[[<wall]]",
            "case.toml:17:3: Error while parsing key: expected bare key starting character or "
            "string delimiter, saw '<'"},
        Bad{"[0.5, 0.5]", "[0.5 \u00b5, 0.5]",
            "case.toml:22:17: Error while parsing array: expected comma or closing ']', saw "
            "'\u00b5'"}));

INSTANTIATE_TEST_SUITE_P(
    Meaning, BadCase,
    testing::Values(
        Bad{"material = \"water\"", "material = \"watr\"",
            "case.toml:15:12: region.pool.material: \"watr\" is not a material of this case; "
            "did you mean \"water\"?"},
        Bad{"position = [0.5, 0.5]", "kind = \"front\"\nmaterial = \"sand\"",
            "case.toml:23:12: gauge.probe.material: \"sand\" is not a material of this case; "
            "choose one of \"water\""},
        Bad{"[0.5, 0.5]", "[0.5, 5]",
            "case.toml:22:12: gauge.probe.position: [0.5, 5] is outside the domain"},
        Bad{"gravity = [0, -9.81]",
            "[[region]]\nname = \"b\"\nmaterial = \"water\"\nhydrostatic_level = \"2 m\"\n"
            "half_plane = { point = [0, 1], normal = [0, 1] }",
            "case.toml:9:21: region.b.hydrostatic_level: \"2 m\" needs gravity; give "
            "physics.gravity"},
        Bad{"material = \"water\"",
            "material = \"water\"\npressure = 1\ndensity = 1\nspecific_energy = 1",
            "case.toml:16:12: region.pool.pressure: 1 is given together with density and "
            "specific_energy; leave out one of the three"},
        Bad{"material = \"water\"", "material = \"water\"\npressure = 1\nhydrostatic_level = 1",
            "case.toml:17:21: region.pool.hydrostatic_level: 1 is given together with pressure; "
            "give one of the two"},
        Bad{"material = \"water\"", "material = \"water\"\ndensity = 1\nhydrostatic_level = 1",
            "case.toml:16:11: region.pool.density: 1 is given together with hydrostatic_level; "
            "leave it out, it is solved for the pressure"},
        Bad{"[[region]]\nname = \"pool\"\nmaterial = \"water\"\n"
            "box = { min = [0, 0], max = [1, 1] }\n",
            "",
            "case.toml: region: is missing: a case needs at least one [[region]]; or a run "
            "to start from, start.run"},
        Bad{"[[gauge]]", "[[gauge]]\nname = \"probe\"\nposition = [0, 0]\n[[gauge]]",
            "case.toml:24:8: gauge[2].name: \"probe\" is used twice"},
        Bad{"box = {", "disc = { center = [0, 0], radius = 1 }\nbox = {",
            "case.toml:13:1: region.pool: has 2 of box, disc, half_plane, "
            "cylinder, polygon or stl; only one is possible"},
        Bad{"box = { min = [0, 0], max = [1, 1] }", "",
            "case.toml:13:1: region.pool: needs one of box, disc, half_plane, cylinder, "
            "polygon or stl"},
        Bad{"box = { min = [0, 0], max = [1, 1] }", "box = 3",
            "case.toml:16:7: region.pool.box: 3 must be a table"},
        Bad{"box = { min = [0, 0], max = [1, 1] }", "box = { min = [0, 1], max = [1, 1] }",
            "case.toml:16:29: region.pool.box.max: [1, 1] must be greater than min along y"},
        Bad{"box = { min = [0, 0], max = [1, 1] }",
            "half_plane = { point = [0, 0], normal = [0, 0] }",
            "case.toml:16:41: region.pool.half_plane.normal: [0, 0] must not be zero"},
        Bad{"box = { min = [0, 0], max = [1, 1] }", "disc = { center = [0, 0], radius = 1.5 }",
            "case.toml:16:19: region.pool.disc.center: [0, 0] puts the disc partly outside the "
            "domain"},
        Bad{"container = { min = [0, 0]", "container = { min = [-3, 0]",
            "case.toml:19:21: wall.tank.container.min: [-3, 0] is outside the domain"},
        Bad{"max = [2, 2] }", "max = [2.005, 2] }\nperiodic = [\"x\"]",
            "case.toml:4:34: space.domain.max: [2.005, 2] makes the periodic domain 300.5 spacings "
            "long along x; a whole number is expected"}));

TEST(BadCases, AllMistakesAreShownTogether) {
  std::string const text = R"(titel = "µ, so that bytes and columns differ"
[space]
dimension = 4
[resolution]
spacing = "3 kg"
[material.water]
eos = "tait"
[[region]]
name = "pool"
material = "watr"
density = "1 g/cm^2"   # µ
box = { min = [0, "1 µm"], max = [1, "1 µg"] }
)";
  EXPECT_EQ(message_of(text),
            "case.toml: time.end: is missing: end of the simulation\n"
            "case.toml:1:1: titel: is an unknown key; did you mean \"title\"?\n"
            "case.toml:3:13: space.dimension: 4 must be between 1 and 3\n"
            "case.toml:5:11: resolution.spacing: \"3 kg\" is a mass; a length is expected (m)\n"
            "case.toml:10:12: region.pool.material: \"watr\" is not a material of this case; did "
            "you mean \"water\"?\n"
            "case.toml:11:11: region.pool.density: \"1 g/cm^2\" has another dimension; a density "
            "is expected (kg/m^3)\n"
            "case.toml:12:38: region.pool.box.max: \"1 µg\" is a mass; a length is expected (m)");
}

TEST(BadCases, AFileThatCannotBeReadIsAnInputError) {
  for (auto const& [path, rule] :
       {std::pair<std::string, std::string>("/nonexistent/case.toml", "does not exist"),
        std::pair<std::string, std::string>("/", "is a folder, not a case file")}) {
    try {
      read_case(path);
      ADD_FAILURE() << path << " was read";
    } catch (InputErrors const& errors) {
      EXPECT_EQ(errors.what(), path + ": " + rule);
    }
  }
}

}  // namespace
}  // namespace moraine
