// What stages give and take is booked: damping, detonation, walls that go.
#include "step/booked_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "output/energy_budget.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

struct Closure {
  EnergyBudget budget;
  BookedEnergy booked;
  double internal = 0.0;  // change of internal energy [J]
  double error = 0.0;     // J
  double largest = 0.0;   // largest part of the change of internal energy [J]
  double parts() const {
    return budget.compression() + budget.viscosity() + budget.wall_viscosity() + booked.detonation;
  }
};

Closure run(Model model) {
  Simulation simulation(std::move(model));
  Closure result;
  simulation.on_new_rates([&](Simulation const& s) { result.budget.tell_new_rates(s); });
  result.budget.tell(simulation);
  double const start = simulation.sums().internal_energy;
  while (simulation.running()) {
    simulation.advance();
    result.budget.tell(simulation);
  }
  result.booked = simulation.booked();
  result.internal = simulation.sums().internal_energy - start;
  result.error = result.budget.error(simulation);
  result.largest =
      std::fabs(result.budget.compression()) + result.budget.viscosity() + result.booked.detonation;
  EXPECT_EQ(simulation.lost().count, 0U);
  return result;
}

Model damped_dam_break(double step) {
  Model model = small_dam_break(2, Precision::full, 0.1);
  model.time.fixed_step = step;
  model.stages = {{"settle", 20.0, {}, {}, {}}};
  return model;
}

// Damping takes energy and books it; without it the total would be off by all of that.
TEST(BookedEnergy, OfDampingClosesTheTotal) {
  Closure const c = run(damped_dam_break(1e-4));
  EXPECT_LT(c.booked.damping, -5.0) << "J per metre of width";
  EXPECT_LT(std::fabs(c.error), 1e-6 * std::fabs(c.booked.damping))
      << "of second order in the step";
  // Damping is no part of the heat: the same rates with the same weights, rounding alone is left.
  EXPECT_NEAR(c.parts(), c.internal, 1e-11 * c.largest);
}

struct Slowed {
  double start = 0.0, gone = 0.0, booked = 0.0;  // J
};

/// A slug in free motion, damped for two of its times.
Slowed slowed(double step) {
  Case c = parse_case(R"(
space = { dimension = 1, domain = { min = [-1.0], max = [3.0] } }
resolution.spacing = 0.1
time.end = 0.2
material.water = { eos = "tait", reference_sound_speed = 10.0 }
[[region]]
name = "slug"
material = "water"
box = { min = [0.0], max = [1.0] }
velocity = [2.0]
[[stage]]
name = "damped"
damping_time = 0.1
)",
                      "case.toml");
  c.time.fixed_step = step;
  Simulation simulation(build_model(c));
  Slowed result;
  result.start = simulation.sums().kinetic_energy;
  while (simulation.running()) simulation.advance();
  result.gone = simulation.sums().kinetic_energy - result.start;
  result.booked = simulation.booked().damping;
  return result;
}

// The kinetic energy that is gone is what is booked, to second order.
TEST(BookedEnergy, OfDampingIsWhatMotionLoses) {
  Slowed const coarse = slowed(2e-3);
  Slowed const fine = slowed(1e-3);
  EXPECT_LT(fine.gone, -0.9 * fine.start);
  EXPECT_NEAR(fine.booked, fine.gone, 1e-4 * fine.start) << "(dt / T)^2";
  double const ratio = (coarse.booked - coarse.gone) / (fine.booked - fine.gone);
  EXPECT_NEAR(std::log2(ratio), 2.0, 0.1);
}

std::string blast_and_gate() {
  return R"(
space.dimension = 1
space.domain = { min = [-0.1], max = [1.1] }
resolution = { spacing = 0.01, smoothing_factor = 2.0 }
numerics.precision = "double"
time.end = 60e-6
material.water = { eos = "water_polynomial" }
material.casing = { eos = "tait", reference_density = 1630.0, reference_sound_speed = 2000.0 }
material.tnt = { eos = "jwl" }
[[region]]
name = "water"
material = "water"
box = { min = [0.0], max = [1.0] }
velocity = [50.0]
[[region]]
name = "charge"
material = "casing"
box = { min = [0.0], max = [0.1] }
[[wall]]
name = "ends"
container = { min = [0.0], max = [1.0] }
[[wall]]
name = "gate"
container = { min = [0.0], max = [0.99] }
[[stage]]
name = "wait"
until = { after = "20 us" }
[[stage]]
name = "bang"
detonate = "charge"
into = "tnt"
until = { after = "10 us" }
[[stage]]
name = "open"
remove_wall = "gate"
)";
}

// Both change the rates between two steps: the step before ends with the old ones, the one after
// begins with the new ones.
TEST(BookedEnergy, ClosesThroughADetonationAndAGateThatOpens) {
  Closure const c = run(build_model(parse_case(blast_and_gate(), "case.toml")));
  double const energy = Jwl{}.reference_energy;
  EXPECT_NEAR(c.booked.detonation, 163.0 * energy, 1e-3 * 163.0 * energy) << "0.1 m of charge";
  EXPECT_NEAR(c.parts(), c.internal, 1e-12 * c.largest) << "rounding";
  EXPECT_LT(std::fabs(c.error), 1e-3 * c.booked.detonation);
  EXPECT_EQ(c.booked.damping, 0.0);
}

}  // namespace
}  // namespace moraine
