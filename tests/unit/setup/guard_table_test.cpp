// The table [guards] of a case: what it sets, what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/explain_step.hpp"
#include "setup/read_case.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

std::string with(std::string const& guards) {
  return R"(space.dimension = 1
resolution.spacing = 0.1
time.end = 1.0
material.water = { eos = "tait", reference_sound_speed = 10.0 }
)" + guards +
         R"(
[[region]]
name = "water"
material = "water"
box = { min = [0.0], max = [1.0] }
)";
}

TEST(GuardTable, ReachesTheModelAndTheUsedCase) {
  Case const c = parse_case(with("guards = { interval = 7, off = [\"walls\", \"budget\"], "
                                 "compression = 2.5, speed = inf }"),
                            "case.toml");
  GuardSettings const guards = build_model(c).guards;
  EXPECT_EQ(guards.interval, 7);
  EXPECT_FALSE(guards.looks(Guard::walls));
  EXPECT_FALSE(guards.looks(Guard::budget));
  EXPECT_TRUE(guards.looks(Guard::density));
  EXPECT_EQ(guards.compression, 2.5);
  EXPECT_FALSE(guards.expansion.has_value());
  EXPECT_TRUE(std::isinf(guards.speed));
  std::string const text = used_case(c);
  EXPECT_EQ(used_case(parse_case(text, "used.toml")), text);
  EXPECT_NE(explain_step(c).find("every 7 steps; off: walls, budget"), std::string::npos);
}

TEST(GuardTable, RefusesWhatIsNoBound) {
  auto const message = [](std::string const& guards) {
    try {
      parse_case(with("guards." + guards), "case.toml");
    } catch (InputErrors const& errors) {
      return std::string(errors.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("off = [\"walls\"]"), "");
  EXPECT_NE(
      message("off = [\"wals\"]").find("\"wals\" is not a known name; did you mean \"walls\"?"),
      std::string::npos)
      << message("off = [\"wals\"]");
  EXPECT_NE(message("off = [\"finite\"]"), "") << "looks always";
  for (char const* const bad : {"interval = 0", "compression = 1.0", "speed = 0.0",
                                "wall_depth = -0.5", "time_step = 2.0", "energy_budget = \"1 m\""})
    EXPECT_NE(message(bad).find("case.toml:5:"), std::string::npos) << bad << ": " << message(bad);
}

}  // namespace
}  // namespace moraine
