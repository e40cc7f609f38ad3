// Mistakes in shapes, layers and starts, with the exact message.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include "base/input_error.hpp"
#include "setup/fill.hpp"
#include "setup/initial_state.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "support/bodies.hpp"
#include "support/places.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

std::string text_of(int dimension, std::string const& region) {
  return "[space]\ndimension = " + std::to_string(dimension) +
         "\n[resolution]\nspacing = 0.1\n[time]\nend = 1\n[material.water]\neos = \"tait\"\n" +
         "[physics]\ngravity = " +
         (dimension == 1   ? "[-9.81]"
          : dimension == 2 ? "[0, -9.81]"
                           : "[0, 0, -9.81]") +
         "\n[[region]]\nname = \"pool\"\n" + region;
}

std::string error_of(std::string const& text) {
  return message_of<InputErrors>([&] { parse_case(text, "case.toml"); });
}

struct Bad {
  int dimension;
  char const* region;  // from line 13 on
  char const* message;
};

class BadGeometry : public testing::TestWithParam<Bad> {};

TEST_P(BadGeometry, GivesItsMessage) {
  auto const& [dimension, region, message] = GetParam();
  EXPECT_EQ(error_of(text_of(dimension, region)), message);
}

#define WATER "material = \"water\"\n"

INSTANTIATE_TEST_SUITE_P(
    Shapes, BadGeometry,
    testing::Values(
        Bad{2, WATER "polygon.corners = [[0, 0], [1, 0]]",
            "case.toml:14:19: region.pool.polygon.corners: [[0, 0], [1, 0]] has 2 corners; at "
            "least 3 are needed"},
        Bad{2, WATER "polygon.corners = [[0, 0], [1, 1], [1, 0], [0, 1]]",
            "case.toml:14:19: region.pool.polygon.corners: [[0, 0], [1, 1], [1, 0], [0, 1]] meets "
            "itself: the side from corner 1 at (0, 0) and the side from corner 3 at (1, 0)"},
        Bad{2, WATER "polygon.corners = [[0, 0], [1, 1, 2], [1, 0]]",
            "case.toml:14:28: region.pool.polygon.corners: [1, 1, 2] is no corner; two numbers, "
            "[x, y], are expected"},
        Bad{2, WATER "polygon.corners = 7",
            "case.toml:14:19: region.pool.polygon.corners: 7 is an integer; a list of corners, "
            "[[x, y], ...], is expected"},
        Bad{2, WATER "polygon = { corners = [[0, 0], [1, 0], [0, 1]], to = 2 }",
            "case.toml:14:54: region.pool.polygon.to: 2 is given in 2D; leave it out"},
        Bad{3, WATER "polygon = { corners = [[0, 0], [1, 0], [0, 1]], to = 2 }",
            "case.toml:14:23: region.pool.polygon.from: is missing: in 3D a polygon is a prism"},
        Bad{3, WATER "polygon = { corners = [[0, 0], [1, 0], [0, 1]], from = 2, to = 2 }",
            "case.toml:14:64: region.pool.polygon.to: 2 must be greater than from"},
        Bad{1, WATER "polygon.corners = [[0, 0], [1, 0], [0, 1]]",
            "case.toml:14:19: region.pool.polygon.corners: [[0, 0], [1, 0], [0, 1]] is not "
            "possible in 1D; give a box"},
        Bad{2, WATER "cylinder = { start = [1, 1], end = [1, 1], radius = 1 }",
            "case.toml:14:36: region.pool.cylinder.end: [1, 1] must differ from start"},
        Bad{2, WATER "cylinder = { start = [1, 1], end = [2, 1], radius = 0 }",
            "case.toml:14:53: region.pool.cylinder.radius: 0 must be greater than 0 m"},
        Bad{2, WATER "stl = { file = \"a.stl\", units = \"mm\" }",
            "case.toml:14:16: region.pool.stl.file: \"a.stl\" is a body in 3D; this case has 2D; "
            "give a polygon"},
        Bad{3, WATER "stl = { file = \"a.stl\" }",
            "case.toml:14:7: region.pool.stl.units: is missing: length unit of the numbers in the "
            "file, such as \"mm\""},
        Bad{3, WATER "stl = { file = \"a.stl\", units = \"kg\" }",
            "case.toml:14:33: region.pool.stl.units: \"kg\" is a mass; a length is expected (m)"},
        Bad{3, WATER "stl = { file = \"nowhere.stl\", units = \"mm\" }",
            "case.toml:14:16: region.pool.stl.file: \"nowhere.stl\" does not exist"}));

#define BOX "box = { min = [0, 0], max = [1, 1] }\n"
#define DOMAIN "[space.domain]\nmin = [0, 0]\nmax = [1, 1]\n"

// A shape with one mistake and a given domain: nothing is looked at that is not there.
INSTANTIATE_TEST_SUITE_P(
    Domains, BadGeometry,
    testing::Values(
        Bad{2, WATER BOX "plus = [{ box = { min = [0, 0], max = [2, 1] } }]\n" DOMAIN,
            "case.toml:15:25: region.pool.plus[1].box.min: [0, 0] puts the box partly outside the "
            "domain"},
        Bad{2, WATER "cylinder = { start = [0.5, 0], end = [0.5, 1], radius = 1 }\n" DOMAIN,
            "case.toml:14:22: region.pool.cylinder.start: [0.5, 0] puts the cylinder partly "
            "outside the domain"},
        Bad{3,
            WATER "stl = { file = \"a.stl\", units = \"kg\" }\n[space.domain]\n"
                  "min = [0, 0, 0]\nmax = [1, 1, 1]\n",
            "case.toml:14:33: region.pool.stl.units: \"kg\" is a mass; a length is expected (m)"},
        Bad{3,
            WATER "polygon = { corners = [[0, 0], [1, 0], [0, 1]], to = 1 }\n[space.domain]\n"
                  "min = [0, 0, 0]\nmax = [1, 1, 1]\n",
            "case.toml:14:23: region.pool.polygon.from: is missing: in 3D a polygon is a prism"}));

INSTANTIATE_TEST_SUITE_P(
    Trees, BadGeometry,
    testing::Values(
        Bad{2, WATER "box = { min = [0, 0], max = [1, 1] }\nminus = 3",
            "case.toml:15:9: region.pool.minus: 3 is an integer; a list of shapes, [{ ... }, "
            "...], is expected"},
        Bad{2, WATER "box = { min = [0, 0], max = [1, 1] }\nminus = [3]",
            "case.toml:15:10: region.pool.minus[1]: 3 is no shape; write { disc = { ... } }"},
        Bad{2,
            WATER "box = { min = [0, 0], max = [1, 1] }\n"
                  "minus = [{ disk = { center = [0, 0], radius = 1 } }]",
            "case.toml:15:10: region.pool.minus[1]: needs one of box, disc, half_plane, cylinder, "
            "polygon or stl\n"
            "case.toml:15:12: region.pool.minus[1].disk: is an unknown key; did you mean "
            "\"disc\"?"},
        Bad{2,
            WATER "box = { min = [0, 0], max = [1, 1] }\n"
                  "plus = [{ box = { min = [0, 0], max = [0, 1] }, minus = [{ half_plane = { "
                  "point = [0, 0], normal = [0, 0] } }] }]",
            "case.toml:15:39: region.pool.plus[1].box.max: [0, 1] must be greater than min along "
            "x\n"
            "case.toml:15:100: region.pool.plus[1].minus[1].half_plane.normal: [0, 0] must not be "
            "zero"}));

INSTANTIATE_TEST_SUITE_P(
    Starts, BadGeometry,
    testing::Values(
        Bad{2, "box = { min = [0, 0], max = [1, 1] }",
            "case.toml:11:1: region.pool.material: is missing: name of a material, or give "
            "layers"},
        Bad{2,
            WATER "box = { min = [0, 0], max = [1, 1] }\n"
                  "layers = { materials = [\"water\"], thickness = [] }",
            "case.toml:13:12: region.pool.material: \"water\" is given together with "
            "layers.materials; give one of the two"},
        Bad{2,
            "box = { min = [0, 0], max = [1, 1] }\n"
            "layers = { materials = [\"water\", \"watr\"], thickness = [1, 1, 1] }",
            "case.toml:14:24: region.pool.layers.materials: [\"water\", \"watr\"] names \"watr\", "
            "which is not a material of this case; did you mean \"water\"?\n"
            "case.toml:14:55: region.pool.layers.thickness: [1, 1, 1] has 3 entries for 2 "
            "materials; 1 or 2 are expected"},
        Bad{2,
            "half_plane = { point = [0, 0], normal = [0, 1] }\n"
            "layers = { materials = [\"water\"], thickness = [] }",
            "case.toml:11:1: region.pool.layers.top: is missing: the shape has no highest point"},
        Bad{2, WATER "box = { min = [0, 0], max = [1, 1] }\nrotation = { rate = \"3 m/s\" }",
            "case.toml:15:21: region.pool.rotation.rate: \"3 m/s\" is a velocity; an angular "
            "velocity is expected (rad/s)"},
        Bad{2, WATER "box = { min = [0, 0], max = [1, 1] }\nrotation = { rate = 1, axis = [1, 0] }",
            "case.toml:15:31: region.pool.rotation.axis: [1, 0] is given in 2D; leave it out: the "
            "axis is z"},
        Bad{2, WATER "box = { min = [0, 0], max = [1, 1] }\nvelocity_field = [\"x\"]",
            "case.toml:15:18: region.pool.velocity_field: [\"x\"] has 1 formulas; 2 are expected, "
            "one "
            "for each axis"},
        Bad{2, WATER "box = { min = [0, 0], max = [1, 1] }\nvelocity_field = [\"x\", \"2 m/s\"]",
            "case.toml:15:18: region.pool.velocity_field: [\"x\", \"2 m/s\"] holds \"2 m/s\", "
            "which is no "
            "formula of x, y, z: Unexpected token \"m\" found at position 2.; formulas have no "
            "units: lengths in m, velocities in m/s"},
        Bad{2, WATER "box = { min = [0, 0], max = [1, 1] }\nlithostatic_load = -1",
            "case.toml:15:20: region.pool.lithostatic_load: -1 must be at least 0 Pa"},
        Bad{2, WATER "box = { min = [0, 0], max = [1, 1] }\nlithostatic_load = 0\npressure = 1",
            "case.toml:15:20: region.pool.lithostatic_load: 0 is given together with pressure; "
            "give one of the two"}));

class StlFiles : public ScratchFolder {
 protected:
  std::string case_with(std::string const& more = "") {
    return text_of(
        3, WATER "stl = { file = \"body.stl\", units = \"cm\", shift = [1, 2, 3]" + more + " }\n");
  }
};

TEST_F(StlFiles, AreReadFromBesideTheCase) {
  write(path("body.stl"), stl_binary(cube({0, 0, 0}, 50)));
  write(path("case.toml"), case_with());
  Case const c = read_case(path("case.toml"));
  auto const& stl = std::get<StlBody>(c.regions[0].shape);
  EXPECT_EQ(stl.body->report.min, (Point{1, 2, 3}));
  EXPECT_EQ(stl.body->report.max, (Point{1.5, 2.5, 3.5}));
  EXPECT_NEAR(stl.body->report.volume, 0.125, 1e-15);
  std::string const used = used_case(c);  // works from any folder
  EXPECT_EQ(used_case(parse_case(used, "elsewhere/used.toml")), used);
}

TEST_F(StlFiles, WithHolesAreRefusedUntilAccepted) {
  auto body = cube({0, 0, 0}, 50);
  body.erase(body.begin());
  write(path("body.stl"), stl_text(body));
  write(path("case.toml"), case_with());
  std::string const file = path("case.toml").string();
  EXPECT_EQ(message_of<InputErrors>([&] { read_case(file); }),
            file +
                ":14:16: region.pool.stl.file: \"body.stl\" does not close a body: 3 open "
                "edges around (1, 2, 3) to (1.5, 2.5, 3); mend it, or give defects = "
                "\"accept\" and look at moraine preview");
  write(path("case.toml"), case_with(", defects = \"accept\""));
  EXPECT_NO_THROW(read_case(file));
}

// Every shape, both lists and their nesting, layers and both starts.
TEST(UsedGeometry, ReadsBackToTheSameCase) {
  std::string const text =
      text_of(2, R"(layers = { materials = ["water", "water"], thickness = ["30 cm"], top = 0.9 }
polygon.corners = [["10 cm", 0], [1, 0], [0, 1]]
rotation = { rate = "10 deg/s", center = [0.1, 0.2] }
velocity_field = ["x * y", "sin(pi * x) / 10"]
lithostatic_load = "1 kPa"
plus = [{ cylinder = { start = [0, 0], end = [1, 1], radius = 0.3 } }]
minus = [{ disc = { center = [0, 0], radius = 0.1 }, plus = [{ box = { min = [0, 0], max = [0.1, 0.1] } }], minus = [{ half_plane = { point = [0, 0], normal = [3, 4] } }] }]
)");
  Case const c = parse_case(text, "case.toml");
  std::string const once = used_case(c);
  Case const again = parse_case(once, "used.toml");
  EXPECT_EQ(used_case(again), once);
  EXPECT_EQ(again.regions[0].layers.thickness, (std::vector<double>{0.3}));
  EXPECT_EQ(again.regions[0].initial.rotation.center, (Point{0.1, 0.2, 0}));
  Point const start = initial_velocity(again.regions[0].initial, {0.5, 0.2, 0.0});
  EXPECT_DOUBLE_EQ(start[0], 0.5 * 0.2);
  EXPECT_DOUBLE_EQ(start[1], 0.1 + (0.5 - 0.1) * std::numbers::pi / 18.0);  // and the rotation
  ASSERT_EQ(again.regions[0].minus.size(), 1U);
  auto const& inner = again.regions[0].minus[0].minus[0];
  EXPECT_DOUBLE_EQ(std::get<HalfPlane>(inner.shape).normal[1], 0.8);
  std::string const prism =
      text_of(3, WATER
              "polygon = { corners = [[0, 0], [1, 0], [0, 1]], axis = \"y\", from = 0, to = 2 }\n"
              "rotation = { rate = 1, axis = [1, 0, 0] }");
  std::string const used = used_case(parse_case(prism, "case.toml"));
  EXPECT_EQ(used_case(parse_case(used, "used.toml")), used);
  EXPECT_NE(used.find("polygon.axis = \"y\""), std::string::npos);
}

// The case on the page about geometry is one.
TEST(GeometryPage, ShowsACase) {
  std::ifstream stream(source_folder() + "/docs/geometry.md");
  std::string const page{std::istreambuf_iterator<char>(stream), {}};
  auto const begin = page.find("```toml\n") + 8;
  Case const c = parse_case(page.substr(begin, page.find("```", begin) - begin), "geometry.md");
  EXPECT_EQ(c.regions.size(), 2U);
  EXPECT_EQ(fill_regions(c).size(), 1500U);
}

}  // namespace
}  // namespace moraine
