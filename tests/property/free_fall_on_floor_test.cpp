// Lists must notice what comes from afar: a block of water in free fall has no relative motion
// inside, and starts several list radii above the floor.
#include <gtest/gtest.h>

#include <algorithm>

#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr char const* falling_block = R"(
space = { dimension = 2, domain = { min = [-1.0, -1.0], max = [2.0, 2.0] } }
physics.gravity = [0.0, -9.81]
resolution = { spacing = 0.02, smoothing_factor = 1.5 }
numerics = { viscosity_alpha = 0.1, viscosity_beta = 0.0 }
time = { end = 0.4, courant = 0.15 }
material.water = { eos = "tait", reference_sound_speed = 30.0 }
[[region]]
name = "block"
material = "water"
box = { min = [0.2, 0.4], max = [0.4, 0.6] }
[[region]]
name = "drop"
material = "water"
box = { min = [0.6, 0.8], max = [0.7, 0.9] }
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [1.0, 1.0] }
open = ["y+"]
)";

// The fall of the block takes sqrt(2 * 0.4 m / g) = 0.29 s.
TEST(FreeFall, EndsOnTheFloor) {
  Simulation simulation(build_model(parse_case(falling_block, "falling-block")));
  std::size_t const count = simulation.particles().range(Kind::fluid).size();
  double const energy = simulation.sums().total_energy();
  while (simulation.running()) simulation.advance();
  auto const y = simulation.particles().component(Field::position, 1);
  EXPECT_EQ(simulation.lost().count, 0U);
  ASSERT_EQ(simulation.particles().range(Kind::fluid).size(), count);
  EXPECT_GT(*std::min_element(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(count)), 0.0);
  // Pairs met too late would gain energy for good. What is left is the time integration's: 2.6e-3,
  // 3.5e-4 and 5e-5 of the energy at Courant factors 0.3, 0.15 and 0.075.
  EXPECT_NEAR(simulation.sums().total_energy(), energy, 1e-3 * energy);
}

}  // namespace
}  // namespace moraine
