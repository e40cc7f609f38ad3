// Mistakes in motions of walls and in symmetry planes, with the exact message.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "base/input_error.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "support/bodies.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

// `space` on line 3, `wall` from line 16 on.
std::string text_of(std::string const& space, std::string const& wall) {
  return "[space]\ndimension = 2\n" + space +
         "\n[resolution]\nspacing = 0.1\n[time]\nend = 1\n[material.water]\neos = \"tait\"\n"
         "[physics]\ngravity = [0, -9.81]\n[[region]]\nname = \"pool\"\nmaterial = \"water\"\n"
         "box = { min = [0, 0], max = [2, 1] }\n[[wall]]\n" +
         wall;
}

std::string const tank = "name = \"tank\"\ncontainer = { min = [0, 0], max = [2, 2] }\n";

std::string error_of(std::string const& text) {
  return message_of<InputErrors>([&] { parse_case(text, "case.toml"); });
}

struct Bad {
  std::string space, wall;
  char const* message;
};

class BadMotion : public testing::TestWithParam<Bad> {};

TEST_P(BadMotion, GivesItsMessage) {
  auto const& [space, wall, message] = GetParam();
  EXPECT_EQ(error_of(text_of(space, wall)), message);
}

INSTANTIATE_TEST_SUITE_P(
    , BadMotion,
    testing::Values(
        Bad{"", tank + "motion.translation = [\"t\"]",
            "case.toml:19:22: wall.tank.motion.translation: [\"t\"] has 1 formulas; 2 are "
            "expected, one for each axis"},
        Bad{"", tank + "motion.translation = [\"x\", \"0\"]",
            "case.toml:19:22: wall.tank.motion.translation: [\"x\", \"0\"] holds \"x\", which is "
            "no "
            "formula of t: Unexpected token \"x\" found at position 0.; formulas have no units: "
            "lengths in m, angles in rad, t in s"},
        Bad{"", tank + "motion.translation = [\"1/t\", \"0\"]",
            "case.toml:19:22: wall.tank.motion.translation: [\"1/t\", \"0\"] holds \"1/t\", which "
            "is "
            "no finite number at t = 0 s"},
        Bad{"", tank + "motion.rotation = \"sin(\"",
            "case.toml:19:19: wall.tank.motion.rotation: \"sin(\" holds \"sin(\", which is no "
            "formula "
            "of t: Unexpected end of expression at position 5; formulas have no units: lengths in "
            "m, angles in rad, t in s"},
        Bad{"", tank + "motion.about = [1, 1]",
            "case.toml:19:16: wall.tank.motion.about: [1, 1] says how to turn, but nothing turns; "
            "give motion.rotation or motion.file"},
        Bad{"", tank + "motion = { rotation = \"t\", axis = [0, 1] }",
            "case.toml:19:35: wall.tank.motion.axis: [0, 1] is possible in 3D only; leave it out"},
        Bad{"", tank + "motion = { rotation = \"t\", file = \"m.csv\" }",
            "case.toml:19:35: wall.tank.motion.file: \"m.csv\" is given together with formulas; "
            "leave "
            "out one of the two"},
        Bad{"", tank + "motion.file = \"nowhere.csv\"",
            "case.toml:19:15: wall.tank.motion.file: \"nowhere.csv\" does not exist"},
        Bad{"", tank + "motion.translation = [\"0.1*cos(t)\", \"0\"]",
            "case.toml:19:22: wall.tank.motion.translation: [\"0.1*cos(t)\", \"0\"] holds "
            "\"0.1*cos(t)\", which is 0.1 at t = 0; the wall starts where its box is: make it 0 "
            "there"},
        Bad{"", tank + "motion.translation = [\"t>0.5?0.3:0\", \"0\"]",
            "case.toml:19:22: wall.tank.motion.translation: [\"t>0.5?0.3:0\", \"0\"] holds "
            "\"t>0.5?0.3:0\", which jumps by 0.3 before t = 0.500618 s"},
        Bad{"", tank + "motion.rotation = \"t = 1\"",
            "case.toml:19:19: wall.tank.motion.rotation: \"t = 1\" holds \"t = 1\", which is no "
            "formula of t: nothing can be assigned; compare with ==; formulas have no units: "
            "lengths in m, angles in rad, t in s"},
        Bad{"domain = { min = [0, -1], max = [3, 3] }\nsymmetry = [\"x-\"]",
            tank + "motion.translation = [\"0.1*t\", \"0\"]",
            "case.toml:20:22: wall.tank.motion.translation: [\"0.1*t\", \"0\"] moves the wall "
            "across "
            "the symmetry plane x-; compute the whole"},
        Bad{"domain = { min = [-1, -1], max = [3, 3] }",
            tank + "motion.translation = [\"2*t\", \"0\"]",
            "case.toml:19:22: wall.tank.motion.translation: [\"2*t\", \"0\"] moves the wall out of "
            "the "
            "domain; enlarge space.domain"},
        Bad{"symmetry = [\"x-\"]", tank,
            "case.toml:3:12: space.symmetry: [\"x-\"] needs space.domain, on whose sides the "
            "planes "
            "lie"},
        Bad{"domain = { min = [0, -1], max = [3, 3] }\nsymmetry = [\"y-\"]", tank,
            "case.toml:4:12: space.symmetry: [\"y-\"] makes a plane of y-, but gravity points "
            "across "
            "it"},
        Bad{"domain = { min = [0.03, -1], max = [3, 3] }\nsymmetry = [\"x-\"]", tank,
            "case.toml:4:12: space.symmetry: [\"x-\"] puts the plane x- 0.3 spacings from the "
            "lattice's corner; a whole number is expected, half a spacing from the nearest "
            "particles"},
        Bad{"domain = { min = [0, -1], max = [2, 3] }\nperiodic = [\"x\"]\nsymmetry = [\"x-\"]",
            tank,
            "case.toml:5:12: space.symmetry: [\"x-\"] makes a plane of x-, but x is periodic"}));

TEST(Motion, GoesOnAlongAPeriod) {
  std::string const domain = "periodic = [\"x\"]\ndomain = { min = [0, -1], max = [2, 3] }";
  EXPECT_NO_THROW(
      parse_case(text_of(domain, tank + "motion.translation = [\"5*t\", \"0\"]"), "case.toml"));
  EXPECT_NE(error_of(text_of(domain, tank + "motion.translation = [\"0\", \"5*t\"]"))
                .find("out of the domain"),
            std::string::npos);
}

TEST(Motion, MattersAsLongAsTheWallIsThere) {
  std::string const gate =
      "name = \"gate\"\nsolid = { min = [2, 0], max = [2.4, 2] }\n"
      "motion.translation = [\"2*t\", \"0\"]\n";
  std::string const domain = "domain = { min = [-1, -1], max = [3, 3] }";
  auto const stages = [](std::string const& until) {
    return "[[stage]]\nname = \"opening\"\nuntil = " + until +
           "\n[[stage]]\nname = \"open\"\nremove_wall = \"gate\"\n";
  };
  EXPECT_NE(error_of(text_of(domain, gate)).find("moves the wall out of the domain"),
            std::string::npos);
  EXPECT_NO_THROW(parse_case(text_of(domain, gate + stages("{ after = 0.25 }")), "case.toml"));
  EXPECT_NE(error_of(text_of(domain, gate + stages("{ after = 0.4 }"))).find("out of the domain"),
            std::string::npos);
  // When it goes is not known: the whole of its path counts.
  EXPECT_NE(error_of(text_of(domain, gate + stages("{ rms_speed_below = 1, steady_for = 0.1 }")))
                .find("out of the domain"),
            std::string::npos);
}

class MotionFile : public ScratchFolder {};

struct BadFile {
  char const* text;
  char const* rule;
};

TEST_F(MotionFile, SaysWhatIsWrongAndWhere) {
  for (auto const& [text, rule] :
       {BadFile{"", "is empty"}, BadFile{"# nothing\n", "is empty"},
        BadFile{"x,y\n0,1\n", "line 1 must name the column time and at least one more"},
        BadFile{"time\n0\n1\n", "line 1 must name the column time and at least one more"},
        BadFile{"time,z\n",
                "line 1: \"z\" is no column of a motion in 2D; time, x, y, z and angle are"},
        BadFile{"time;x\n",
                "line 1: \"time;x\" is no column of a motion in 2D; time, x, y, z and angle are, "
                "separated by commas"},
        BadFile{"time,x\n0,1\n1,2\n", "make it 0 there"},
        BadFile{"time,x,x\n", "line 1: \"x\" is named twice"},
        BadFile{"time,x\n0,0\n# pause\n1,a\n", "line 4: \"a\" is not a number"},
        BadFile{"time,x\n0,0\n1\n", "line 3 has 1 columns; 2 are named above"},
        BadFile{"time,x\n0,0\n", "needs at least two times, each with a value"},
        BadFile{"time,x\n0,0\n0,1\n", "has times that do not increase"},
        BadFile{"time,x\n0,0\n1,inf\n", "holds a number that is not finite"},
        BadFile{"time,x\n0,0\n0.5,1\n", "ends at 0.5 s, before the run at 1 s"}}) {
    std::ofstream(path("motion.csv")) << text;
    std::string const file = path("motion.csv").string();
    std::string const error = error_of(text_of("", tank + "motion.file = \"" + file + "\""));
    EXPECT_TRUE(error.starts_with("case.toml:19:15: wall.tank.motion.file: ")) << error;
    EXPECT_TRUE(error.ends_with(rule)) << error;
  }
}

TEST_F(MotionFile, IsRead) {
  std::ofstream(path("motion.csv"))
      << "\xEF\xBB\xBF# shaking table\r\nangle, time ,x\r\n0, 0, 0\n+0.1,0.5,0.25\n\n0.2, 2, 1\n";
  std::string const file = path("motion.csv").string();
  Case const c = parse_case(text_of("", tank + "motion.file = \"" + file + "\""), "case.toml");
  ASSERT_TRUE(c.walls[0].motion.motion);
  RigidMotion const& motion = *c.walls[0].motion.motion;
  EXPECT_DOUBLE_EQ(motion.translation[0].at(0.5).value, 0.25);
  EXPECT_DOUBLE_EQ(motion.rotation.at(0.5).value, 0.1);
  EXPECT_EQ(motion.translation[1].at(0.5).value, 0.0);
  // What is used says the same again, and the domain holds all of the way.
  Case const again = parse_case(used_case(c), "used.toml");
  EXPECT_EQ(again.walls[0].motion.file, file);
  EXPECT_GE(c.domain.max[0], 3.0);
}

TEST(Motion, IsWrittenAsItWasRead) {
  Case const c = parse_case(
      text_of("domain = { min = [-1, -1], max = [3, 3] }\nsymmetry = [\"x+\"]",
              tank + "motion = { translation = [\"0\", \"0.01*sin(3*t)\"], rotation = \"0.1*t\", "
                     "about = [1, 0] }"),
      "case.toml");
  Case const again = parse_case(used_case(c), "used.toml");
  EXPECT_EQ(again.walls[0].motion.translation, c.walls[0].motion.translation);
  EXPECT_EQ(again.walls[0].motion.rotation, "0.1*t");
  EXPECT_EQ(again.walls[0].motion.about, c.walls[0].motion.about);
  EXPECT_TRUE(again.symmetry.planes[0][1]);
}

}  // namespace
}  // namespace moraine
