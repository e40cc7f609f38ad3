// The guard: a state that is no number, or no state, stops the run and names the particle.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "step/simulation_error.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

/// Sixteen particles of one liquid, three spacings apart, at rest and without pressure.
Model scattered() {
  RandomBox box;
  box.side = 4;
  box.scheme = SchemeName::liquid;
  box.displacement = 0.0;
  box.velocity = 0.0;
  Model model = random_box(box, 1.0);
  model.periodic = {};
  model.domain_min = {-1.0, -1.0, 0.0};
  model.domain_max = {1.0, 1.0, 0.0};
  for (int axis = 0; axis < 2; ++axis)
    for (double& x : model.particles.component(Field::position, axis)) x *= 3.0;
  for (double& density : model.particles.scalar(Field::density)) density = 1000.0;
  return model;
}

std::string complaint(Model model, int steps) {
  try {
    Simulation simulation(std::move(model));
    for (int step = 0; step < steps; ++step) simulation.advance();
  } catch (SimulationError const& error) {
    return error.what();
  }
  return "";
}

void expect_named(std::string const& text, std::string const& cause) {
  EXPECT_NE(text.find("unstable: particle 6 (light) at (0.075, 0.045) m: "), std::string::npos)
      << text;
  EXPECT_NE(text.find(cause), std::string::npos) << text;
}

TEST(Guard, LetsAGoodStatePass) { EXPECT_EQ(complaint(scattered(), 10), ""); }

TEST(Guard, NamesTheParticleThatIsNoNumber) {
  for (double const bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    Model energy = scattered();
    energy.particles.scalar(Field::specific_energy)[6] = bad;
    expect_named(complaint(energy, 0),
                 "velocity, density, energy or acceleration is not a finite number");
    for (int axis = 0; axis < 2; ++axis) {
      Model velocity = scattered();
      velocity.particles.component(Field::velocity, axis)[6] = bad;
      expect_named(complaint(velocity, 0),
                   "velocity, density, energy or acceleration is not a finite number");
    }
  }
}

// Infinite and opposite: a sum of them would be no sign of trouble for a less careful check.
TEST(Guard, SeesOppositeInfinities) {
  Model model = scattered();
  model.particles.component(Field::velocity, 0)[6] = std::numeric_limits<double>::infinity();
  model.particles.component(Field::velocity, 1)[6] = -std::numeric_limits<double>::infinity();
  expect_named(complaint(model, 0), "is not a finite number");
}

TEST(Guard, NamesAnAccelerationThatIsNoNumber) {
  Model model = scattered();
  model.gravity[1] = std::numeric_limits<double>::quiet_NaN();
  std::string const text = complaint(model, 0);
  EXPECT_NE(text.find("is not a finite number"), std::string::npos) << text;
}

TEST(Guard, NamesADensityThatIsNone) {
  Model none = scattered();
  none.particles.scalar(Field::density)[6] = std::numeric_limits<double>::quiet_NaN();
  expect_named(complaint(none, 0), "");
  Model negative = scattered();
  negative.particles.scalar(Field::density)[6] = -1.0;
  expect_named(complaint(negative, 0), "density");
}

TEST(Guard, NamesTheStateThatItsLawCannotAnswer) {
  Model model = scattered();
  model.materials = {{"light", IdealGas{}}};
  for (double& energy : model.particles.scalar(Field::specific_energy)) energy = 1e5;
  EXPECT_EQ(complaint(model, 0), "");
  model.particles.scalar(Field::specific_energy)[6] = -1e5;
  expect_named(complaint(model, 0), "the equation of state gives no sound speed");
}

TEST(Guard, NamesTheFirstOfSeveral) {
  Model model = scattered();
  for (std::size_t const i : {6u, 7u, 11u})
    model.particles.scalar(Field::specific_energy)[i] = std::numeric_limits<double>::quiet_NaN();
  // The store is sorted by cells, and 6 comes before 7 and 11 in any order by rows.
  expect_named(complaint(model, 0), "is not a finite number");
}

}  // namespace
}  // namespace moraine
