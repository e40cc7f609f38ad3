// Where energy goes: the parts add up to what the energy equation did, and each is what it says.
#include "output/energy_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "step/simulation_setup.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

struct Closure {
  EnergyBudget budget;
  double internal = 0.0;  // change of internal energy [J]
  double error = 0.0;     // change of the total [J]
  double turnover = 0.0;  // change of kinetic energy [J]
};

Closure after(Model model, int steps) {
  Simulation simulation(std::move(model));
  Closure result;
  result.budget.tell(simulation);
  ConservedSums const start = simulation.sums();
  for (int step = 0; step < steps; ++step) {
    simulation.advance();
    result.budget.tell(simulation);
  }
  ConservedSums const end = simulation.sums();
  result.internal = end.internal_energy - start.internal_energy;
  result.turnover = end.kinetic_energy - start.kinetic_energy;
  result.error = result.budget.error(simulation);
  EXPECT_EQ(simulation.lost().count, 0U);
  return result;
}

class Budget : public testing::TestWithParam<Precision> {};

// Exact for any step: the same rates with the same weights. In mixed precision the dissipative part
// is summed in single precision apart from the whole; compression is what is left, so that the sum
// closes as well.
TEST_P(Budget, PartsAreTheChangeOfInternalEnergy) {
  Closure const c = after(small_dam_break(2, GetParam(), 10.0), 300);
  double const parts = c.budget.compression() + c.budget.viscosity() + c.budget.wall_viscosity();
  // Internal energies of Tait water start at zero; 300 steps of some roundings of the largest part.
  double const size = std::fabs(c.budget.compression()) + c.budget.viscosity();
  EXPECT_NEAR(parts, c.internal, 1e-11 * size);
  EXPECT_GT(c.budget.viscosity(), 0.0);
  EXPECT_GT(c.budget.wall_viscosity(), 0.0);
  EXPECT_GT(c.turnover, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Precisions, Budget, testing::Values(Precision::mixed, Precision::full));

// The total is conserved to second order: half the step, a quarter of the error.
TEST(EnergyBudget, TheTotalClosesToSecondOrder) {
  auto const with_step = [](double step) {
    Model model = small_dam_break(2, Precision::full, 10.0);
    model.time.fixed_step = step;
    return after(std::move(model), static_cast<int>(std::lround(0.06 / step)));
  };
  Closure const coarse = with_step(2e-4);
  Closure const fine = with_step(1e-4);
  EXPECT_LT(std::fabs(coarse.error), 1e-3 * coarse.turnover);
  double const order = std::log2(std::fabs(coarse.error / fine.error));
  EXPECT_NEAR(order, 2.0, 0.3);
}

/// Heating of all particles by a sweep over a box of random velocities [W].
struct Swept {
  double heating = 0.0;
  EnergyRates rates;
};

Swept sweep_with(double alpha, double diffusion, Flavour flavour) {
  RandomBox box;
  box.dimension = 2;
  box.side = 24;
  Model model = walled_random_box(box, 1.0);
  model.numerics.viscosity_alpha = alpha;
  model.numerics.viscosity_beta = 2.0 * alpha;
  model.numerics.density_diffusion = diffusion;
  ParticleStore& store = model.particles;
  Search search(search_settings(model));
  search.refresh(store);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    store.scalar(Field::pressure)[i] = 1e4;
    store.scalar(Field::sound_speed)[i] = 100.0;
  }
  auto const pairs = make_pair_backend(2, flavour, SchemeName::compressible,
                                       sweep_parameters(model), reference_densities(model));
  pairs->gather_fluid(store, search, 0.0);
  pairs->gather_walls(store, search, model.walls);
  pairs->sweep(store, search);
  Swept result;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    result.heating += store.scalar(Field::mass)[i] * store.scalar(Field::energy_rate)[i];
  result.rates = pairs->energy_rates(store, search);
  return result;
}

// The heat of viscosity is what the sweep adds to internal energy because of it.
TEST(EnergyBudget, ViscosityIsTheDifferenceThatItMakes) {
  for (Flavour const flavour : {Flavour::mixed, Flavour::full, Flavour::reference}) {
    Swept const with = sweep_with(1.0, 0.0, flavour);
    Swept const without = sweep_with(0.0, 0.0, flavour);
    double const heat = with.rates.viscosity + with.rates.wall_viscosity;
    double const tolerance = flavour == Flavour::mixed ? 1e-5 : 1e-12;  // of rounding
    EXPECT_NEAR(heat, with.heating - without.heating, tolerance * heat);
    EXPECT_GT(with.rates.viscosity, 0.0);
    EXPECT_GT(with.rates.wall_viscosity, 0.0);
    EXPECT_EQ(without.rates.viscosity, 0.0);
    EXPECT_EQ(without.rates.wall_viscosity, 0.0);
    EXPECT_EQ(with.rates.diffusion, 0.0);
    EXPECT_NE(sweep_with(0.0, 0.1, flavour).rates.diffusion, 0.0);
  }
}

}  // namespace
}  // namespace moraine
