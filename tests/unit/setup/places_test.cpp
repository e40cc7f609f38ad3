// Mistakes that only show when the model is built are located in the file too.
#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"
#include "setup/build_model.hpp"
#include "setup/geometry.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

constexpr std::string_view head = R"([space]
dimension = 2
[resolution]
spacing = 0.1
[time]
end = 1
[material.gas]
eos = "ideal_gas"
)";

std::string error_of(std::string const& rest) {
  try {
    build_model(parse_case(std::string(head) + rest, "case.toml"));
  } catch (InputErrors const& errors) {
    return errors.what();
  }
  return "no error";
}

std::string region(std::string const& name, std::string const& size, std::string const& more = "") {
  return "[[region]]\nname = \"" + name + "\"\nmaterial = \"gas\"\nbox = { min = [0, 0], max = [" +
         size + ", " + size + "] }\n" + more;
}

TEST(Places, OfRegions) {
  EXPECT_EQ(error_of(region("pool", "1") + region("dot", "0.01")),
            "case.toml:13:1: region.dot: fills no particle at a spacing of 0.1 m; it is too small, "
            "outside the walls or covered by a later region");
  EXPECT_EQ(
      error_of(region("pool", "1", "pressure = \"-3 Pa\"\n")),
      "case.toml:13:12: region.pool.pressure: \"-3 Pa\" asks for a pressure that the material "
      "\"gas\" cannot have");
}

TEST(Places, OfWalls) {
  std::string const wall =
      "[[wall]]\nname = \"plate\"\nsolid = { min = [2, 2], max = [2.01, 3] }\n";
  EXPECT_EQ(error_of(region("pool", "1") + wall),
            "case.toml:13:1: wall.plate: box wall: on axis x the box is thinner than the particle "
            "spacing");
}

// A solid wall beside everything else is part of the domain that is found for a case.
TEST(DefaultDomain, HoldsSolidWalls) {
  Case const c =
      parse_case(std::string(head) + region("pool", "1") +
                     "[[wall]]\nname = \"hill\"\nsolid = { min = [4, -2], max = [6, 0] }\n",
                 "case.toml");
  // The box from (0, -2) to (6, 1), and its own extent around it.
  EXPECT_EQ(c.domain.min, (Point{-6.0, -5.0, 0.0}));
  EXPECT_EQ(c.domain.max, (Point{12.0, 4.0, 0.0}));
}

}  // namespace
}  // namespace moraine
