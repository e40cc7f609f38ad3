// Mistakes in the methods of walls, with the exact message.
#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/case_warnings.hpp"
#include "setup/check_walls.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

// The wall's keys are written from line 15 on.
std::string text_of(std::string const& wall) {
  return "[space]\ndimension = 2\n[resolution]\nspacing = 0.1\n[time]\nend = 1\n"
         "[material.water]\neos = \"tait\"\n[[region]]\nname = \"pool\"\nmaterial = \"water\"\n"
         "box = { min = [0, 0], max = [2, 1] }\n[[wall]]\nname = \"tank\"\n" +
         wall;
}

std::string const tank = "container = { min = [0, 0], max = [2, 2] }\n";
std::string const block = "solid = { min = [0, 1], max = [2, 2] }\n";

struct Bad {
  std::string wall;
  char const* message;
};

class BadWalls : public testing::TestWithParam<Bad> {};

TEST_P(BadWalls, GivesItsMessage) {
  auto const& [wall, message] = GetParam();
  EXPECT_EQ(message_of<InputErrors>([&] { build_model(parse_case(text_of(wall), "case.toml")); }),
            message);
}

INSTANTIATE_TEST_SUITE_P(
    , BadWalls,
    testing::Values(
        Bad{block + "method = \"mirror\"",
            "case.toml:16:10: wall.tank.method: \"mirror\" makes images beyond the sides of a "
            "container only; obstacles are \"dummy\" or \"repulsive\""},
        Bad{tank + "method = \"mirror\"\nmotion.translation = [\"t\", \"0\"]",
            "case.toml:16:10: wall.tank.method: \"mirror\" makes images at walls at rest only, but "
            "motion is given; walls that move are \"dummy\" or \"repulsive\""},
        Bad{tank + "method = \"repulsive\"",
            "case.toml:16:10: wall.tank.repulsion: is missing: the method pushes, and needs to "
            "know how hard; 5 g H for a tank of depth H, or the sound speed squared"},
        Bad{tank + "method = \"mirror\"\nrepulsion = 1\nrepulsion_range = 0.01",
            "case.toml:17:13: wall.tank.repulsion: 1 has no effect: the method of the wall does "
            "not push; leave it out, or let method be \"repulsive\"\n"
            "case.toml:18:19: wall.tank.repulsion_range: 0.01 has no effect: the method of the "
            "wall does not push; leave it out, or let method be \"repulsive\""},
        Bad{tank + "method = \"repulsive\"\nslip = \"none\"\nrepulsion = \"4 m^2/s^2\"",
            "case.toml:17:8: wall.tank.slip: \"none\" is not possible: a wall that only pushes has "
            "no friction; use \"dummy\" or \"mirror_and_repulsive\""},
        Bad{tank + "method = \"mirror\"\n[[wall]]\nname = \"other\"\ncontainer = { min = [0, 0], "
                   "max = [2, 2] }\nopen = [\"y-\", \"y+\", \"x+\"]\nmethod = \"mirror\"",
            "case.toml:21:10: wall.other.method: \"mirror\" makes images beyond x-, but wall "
            "\"tank\" does so too"},
        Bad{tank + "method = \"mirror\"\n[[stage]]\nname = \"a\"\nuntil.after = 0.1\n[[stage]]\n"
                   "name = \"b\"\nremove_wall = \"tank\"",
            "case.toml:22:15: stage.b.remove_wall: \"tank\" is a wall without dummy particles, "
            "which cannot be removed; let its method be \"dummy\""},
        Bad{"container = { min = [0, 0], max = [0.4, 2] }\nmethod = \"mirror\"",
            "case.toml:16:10: wall.tank.method: \"mirror\" makes images of a container of 0.4 m "
            "along x, shorter than two kernel supports, 0.48 m; refine the spacing or let it be "
            "\"dummy\""}));

TEST(WallMethods, ComeBackFromTheUsedCase) {
  Case const c = parse_case(
      text_of(tank + "method = \"mirror_and_repulsive\"\nrepulsion = \"4 m^2/s^2\"\nopen = "
                     "[\"y+\"]"),
      "case.toml");
  EXPECT_EQ(c.domain.min, (Point{0.0, 0.0, 0.0}));
  EXPECT_EQ(c.domain.max[0], 2.0);
  EXPECT_GT(c.domain.max[1], 2.0);
  std::string const used = used_case(c);
  Case const again = parse_case(used, "case.toml");
  EXPECT_EQ(again.walls[0].method, WallMethod::mirror_and_repulsive);
  EXPECT_EQ(again.walls[0].repulsion, 4.0);
  EXPECT_EQ(again.domain.max, c.domain.max);
  EXPECT_EQ(used_case(again), used);
}

TEST(WallMethods, WarnOfWhatPushesAtTheStartAndCutsTheLattice) {
  Case const c = parse_case(
      text_of("container = { min = [0, 0], max = [2.04, 2] }\nmethod = \"mirror_and_repulsive\"\n"
              "repulsion = 4\nrepulsion_range = 0.1"),
      "case.toml");
  std::vector<InputProblem> warnings;
  add_wall_warnings(c, warnings);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(format(warnings[0]),
            "case.toml:18:19: wall.tank.repulsion_range: 0.1 is more than half the spacing, 0.05 "
            "m, where the first particles stand: the wall pushes at the start");
  EXPECT_EQ(format(warnings[1]),
            "case.toml:16:10: wall.tank.method: \"mirror_and_repulsive\" puts the mirror x+ 20.4 "
            "spacings from the lattice's corner: with a whole number the first particles stand "
            "half a spacing from it");
}

}  // namespace
}  // namespace moraine
