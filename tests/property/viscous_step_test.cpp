// The time step with physical viscosity: what it bears, and of which order its error is.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "step/simulation.hpp"
#include "step/simulation_setup.hpp"
#include "verify/random_box.hpp"

namespace moraine {
namespace {

/// A liquid so viscous that sound has no say in the time step, nor in the motion.
Model honey(int dimension, ViscosityForm form, double displacement) {
  RandomBox box;
  box.dimension = dimension;
  box.side = dimension == 1 ? 60 : (dimension == 2 ? 16 : 8);
  box.scheme = SchemeName::liquid;
  box.precision = Precision::full;
  box.displacement = displacement;
  box.velocity = 1e-4;
  Model model = random_box(box, 1.0);
  model.numerics.viscosity_alpha = model.numerics.viscosity_beta = 0.0;
  model.numerics.physical_viscosity = form;
  model.materials[0].dynamic_viscosity = 1e6;
  return model;
}

using Variant = std::tuple<int, ViscosityForm, KernelName>;
class ViscousStep : public testing::TestWithParam<Variant> {};

// What is unstable grows by a factor in each step; what is stable comes to rest but for the
// momentum of the whole.
TEST_P(ViscousStep, IsStable) {
  auto const [dimension, form, kernel] = GetParam();
  for (double const displacement : {0.0, 0.2}) {
    Model model = honey(dimension, form, displacement);
    model.numerics.kernel = kernel;
    Simulation simulation(std::move(model));
    double const before = simulation.sums().kinetic_energy;
    for (int step = 0; step < 100; ++step) {
      simulation.advance();
      ASSERT_EQ(simulation.vote().reason, viscous_limit);
      ASSERT_LE(simulation.sums().kinetic_energy, before)
          << displacement << " spacings, step " << step;
    }
  }
}

std::string name_of(testing::TestParamInfo<Variant> const& info) {
  auto const [dimension, form, kernel] = info.param;
  return std::string(form == ViscosityForm::morris ? "morris_" : "monaghan_cleary_") +
         std::to_string(dimension) + "d_" + std::string(kernel_name(kernel));
}

INSTANTIATE_TEST_SUITE_P(
    All, ViscousStep,
    testing::Combine(testing::Values(1, 2, 3),
                     testing::Values(ViscosityForm::morris, ViscosityForm::monaghan_cleary),
                     testing::Values(KernelName::cubic_spline, KernelName::wendland_c2,
                                     KernelName::quintic_spline)),
    name_of);

// A thick liquid beside a light one drags it, in Morris' form with half of the sum of both: the
// step follows what the lightest particle feels.
TEST(ViscousStep, SeesTheThickLiquidBesideTheLightOne) {
  RandomBox box;
  box.displacement = 0.0;
  box.velocity = 1e-6;
  Model model = random_box(box, 1.0);  // 1000 and 3000 kg/m^3
  model.numerics.viscosity_alpha = model.numerics.viscosity_beta = 0.0;
  model.numerics.physical_viscosity = ViscosityForm::morris;
  model.materials[0].dynamic_viscosity = 1.0;
  model.materials[1].dynamic_viscosity = 1e6;
  double const h = model.numerics.smoothing_length();
  double const share = viscous_share(model.numerics, 2);
  Simulation simulation(std::move(model));
  simulation.advance();
  EXPECT_EQ(simulation.vote().reason, viscous_limit);
  EXPECT_NEAR(simulation.time_step(), share * h * h / (0.5 * (1.0 + 1e6) / 1000.0),
              0.02 * simulation.time_step());  // the box starts with densities 1 % off
}

/// Kinetic energy of a shear wave after the same time in `steps` steps.
double energy_after(ViscosityForm form, int steps) {
  Model model = honey(2, form, 0.0);
  ParticleStore& store = model.particles;
  double const k = 2.0 * std::numbers::pi / (model.domain_max[1] - model.domain_min[1]);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    store.component(Field::velocity, 0)[i] =
        1e-3 * std::sin(k * store.component(Field::position, 1)[i]);
    store.component(Field::velocity, 1)[i] = 0.0;
  }
  double const nu = 1e6 / 1000.0;
  model.time.end = 0.5 / (nu * k * k);  // velocities fall to about 0.6
  model.time.fixed_step = model.time.end / steps;
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  return simulation.sums().kinetic_energy;
}

// Halved steps leave a quarter of the error; half of it if viscosity sees velocities of half a step
// ago. The tolerance is for terms of third order.
TEST(ViscousStepOrder, IsSecond) {
  for (ViscosityForm const form : {ViscosityForm::morris, ViscosityForm::monaghan_cleary}) {
    double const one = energy_after(form, 60);
    double const two = energy_after(form, 120);
    double const four = energy_after(form, 240);
    EXPECT_NEAR(std::log2((one - two) / (two - four)), 2.0, 0.2);
  }
}

}  // namespace
}  // namespace moraine
