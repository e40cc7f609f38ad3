// Heavy and light side by side at a wall, whose particles have a density between the two.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "setup/build_model.hpp"
#include "step/simulation_setup.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

constexpr double spacing = 0.1;
constexpr double gas_density = 1.2;
constexpr double pressure = 1e5;

/// Gas over a liquid that is a thousand times denser, one pressure everywhere, in a closed box.
Model gas_over_liquid(int dimension, ContinuityForm continuity, MomentumForm momentum) {
  Case c;
  c.dimension = dimension;
  double const depth = dimension == 3 ? 2.0 : 0.0;
  c.domain = {{-1.0, -1.0, -1.0}, {3.0, 3.0, 3.0}};
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = 1.3;
  c.numerics.precision = Precision::full;
  c.numerics.continuity = continuity;
  c.numerics.momentum = momentum;
  c.time.end = 1.0;
  c.materials = {{.name = "liquid", .eos = Linear{.reference_density = 1200.0}},
                 {.name = "gas", .eos = Linear{.reference_density = gas_density}}};
  c.regions = {{"liquid", "liquid", Box{{0.0, 0.0, 0.0}, {2.0, 1.0, depth}}, {}},
               {"gas", "gas", Box{{0.0, 1.0, 0.0}, {2.0, 2.0, depth}}, {}}};
  WallSpec wall;
  wall.name = "box";
  wall.box = {{0.0, 0.0, 0.0}, {2.0, 2.0, depth}};
  c.walls = {wall};
  Model model = build_model(c);
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    store.scalar(Field::pressure)[i] = pressure;
  return model;
}

void sweep(Model& model) {
  Search search(search_settings(model));
  search.refresh(model.particles);
  auto const pairs = make_pair_backend(model.dimension, Flavour::full, SchemeName::compressible,
                                       sweep_parameters(model), reference_densities(model));
  pairs->gather_fluid(model.particles, search, 0.0);
  pairs->gather_walls(model.particles, search, model.walls);
  pairs->sweep(model.particles, search);
}

/// Largest acceleration, over p / (rho spacing) of the gas.
double unrest(int dimension, MomentumForm momentum) {
  Model model = gas_over_liquid(dimension, ContinuityForm::volume, momentum);
  sweep(model);
  double most = 0.0;
  for (int axis = 0; axis < dimension; ++axis)
    most = std::max(most, largest(model.particles, Field::acceleration, axis));
  return most / (pressure / (gas_density * spacing));
}

class TwoFluidsAtWalls : public testing::TestWithParam<int> {};

// One pressure everywhere pushes nobody: the lattice goes on behind the faces, and its volumes
// alone count. In the conservative form a heavy wall particle weighs on the gas.
TEST_P(TwoFluidsAtWalls, RestUnderOnePressure) {
  EXPECT_LE(unrest(GetParam(), MomentumForm::mixed), 1e-11);
  EXPECT_GE(unrest(GetParam(), MomentumForm::conservative), 10.0);
}

/// Largest of |d rho/dt| / rho of the gas, over that of the liquid, where both run along x with 1
/// m/s, towards one wall and away from another.
double compression_of_gas_by_liquid(int dimension, ContinuityForm continuity) {
  Model model = gas_over_liquid(dimension, continuity, MomentumForm::mixed);
  ParticleStore& store = model.particles;
  for (double& v : store.component(Field::velocity, 0)) v = 1.0;
  sweep(model);
  double of[2] = {0.0, 0.0};
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const rate = store.scalar(Field::density_rate)[i] / store.scalar(Field::density)[i];
    of[store.material()[i]] = std::max(of[store.material()[i]], std::fabs(rate));
  }
  return of[1] / of[0];
}

// A wall that both run against compresses both alike in the volume form; in the mass form the gas
// beside the line between the two is compressed by walls of the mean density.
TEST_P(TwoFluidsAtWalls, AreCompressedAlike) {
  EXPECT_NEAR(compression_of_gas_by_liquid(GetParam(), ContinuityForm::volume), 1.0, 1e-9);
  EXPECT_GE(compression_of_gas_by_liquid(GetParam(), ContinuityForm::mass), 10.0);
}

INSTANTIATE_TEST_SUITE_P(, TwoFluidsAtWalls, testing::Values(2, 3),
                         [](auto const& variant) { return std::to_string(variant.param) + "d"; });

}  // namespace
}  // namespace moraine
