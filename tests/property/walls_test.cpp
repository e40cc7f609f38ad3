// Walls in water at rest: hydrostatic pressure around a submerged block, its buoyancy, and the
// pressure that walls take from the water.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation_setup.hpp"
#include "support/small_models.hpp"
#include "support/tank_with_block.hpp"

namespace moraine {
namespace {

constexpr double rho_0 = 1000.0;  // kg/m^3
constexpr double g = 9.81;        // m/s^2
constexpr double depth = 0.6;     // m
constexpr double sound = 34.3;    // m/s, ten times sqrt(2 g depth)

/// The case with one of its walls only, and the fluid as it is in `state`.
Model with_one_wall(Model const& state, Case const& c, std::size_t wall) {
  Case only = c;
  only.walls = {c.walls[wall]};
  Model result = build_model(only);
  ParticleStore const& from = state.particles;
  ParticleStore& to = result.particles;
  for (std::size_t i = 0; i < from.range(Kind::fluid).size(); ++i) {
    std::size_t const k = from.id()[i];
    for (Field const field : {Field::density, Field::pressure, Field::sound_speed})
      to.scalar(field)[k] = from.scalar(field)[i];
    for (int axis = 0; axis < state.dimension; ++axis)
      for (Field const field : {Field::position, Field::velocity})
        to.component(field, axis)[k] = from.component(field, axis)[i];
  }
  return result;
}

/// Force of one wall on the fluid [N/m].
std::array<double, 3> force_of_wall(Model const& state, Case const& c, std::size_t wall) {
  Model model = with_one_wall(state, c, wall);
  Search search(search_settings(model));
  search.refresh(model.particles);
  auto const pairs = make_pair_backend(model.dimension, model.flavour(), scheme_of(model),
                                       sweep_parameters(model), reference_densities(model));
  pairs->gather_fluid(model.particles, search, 0.0);
  pairs->gather_walls(model.particles, search, model.walls);
  return pairs->sweep(model.particles, search).wall_force;
}

TEST(Walls, StillWaterAroundABlockStaysStillAndBearsIt) {
  Case const c = parse_case(tank_with_block("0.5"), "block");
  Simulation simulation(build_model(c));
  std::size_t const count = simulation.particles().range(Kind::fluid).size();
  double fastest = 0.0;
  while (simulation.running()) {
    simulation.advance();
    for (std::size_t i = 0; i < count; ++i)
      fastest =
          std::max(fastest, std::hypot(simulation.particles().component(Field::velocity, 0)[i],
                                       simulation.particles().component(Field::velocity, 1)[i]));
  }
  double worst = 0.0;
  ParticleStore const& store = simulation.particles();
  for (std::size_t i = 0; i < count; ++i) {
    double const expected = rho_0 * g * (depth - store.component(Field::position, 1)[i]);
    worst = std::max(worst, std::fabs(store.scalar(Field::pressure)[i] - expected));
  }
  auto const block = force_of_wall(simulation.model(), c, 1);
  auto const tank = force_of_wall(simulation.model(), c, 0);
  double const buoyancy = rho_0 * g * 0.2 * 0.2;
  double const weight = g * simulation.sums().mass;
  // The particles stand on a lattice of 30 rows: the pressure of the last row alone is 1.7 % of
  // that at the bottom. Measured 0.6 %, and 2.5e-4 of the speed of sound.
  EXPECT_LE(worst, 0.01 * rho_0 * g * depth);
  EXPECT_LE(fastest, 1e-3 * sound);
  // Archimedes; the block is ten spacings wide. Measured: 0.3 % more, and nothing sideways.
  EXPECT_NEAR(-block[1], buoyancy, 0.01 * buoyancy);
  EXPECT_NEAR(block[0], 0.0, 1e-3 * buoyancy);
  // Tank and block together bear the weight of the water; measured to 3e-5.
  EXPECT_NEAR(tank[1] + block[1], weight, 1e-3 * weight);
}

// p_w = p_f + rho g . x_wf has a linear pressure as its fixed point, wherever the particles are.
TEST(Walls, ContinueHydrostaticPressureExactly) {
  for (int const dimension : {1, 2, 3})
    for (Flavour const flavour : {Flavour::mixed, Flavour::full}) {
      RandomBox box;
      box.dimension = dimension;
      box.side = std::array{0, 100, 24, 10}[static_cast<std::size_t>(dimension)];
      box.scheme = SchemeName::liquid;
      Model model = walled_random_box(box, 1.0);
      model.gravity = {-g, 0.0, 0.0};  // the walls are at both ends of x
      ParticleStore& store = model.particles;
      auto const pressure = [](double x) { return 5e3 - rho_0 * g * x; };
      Search search(search_settings(model));
      search.refresh(store);
      for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
        store.scalar(Field::density)[i] = rho_0;
        store.scalar(Field::sound_speed)[i] = 100.0;
        store.scalar(Field::pressure)[i] = pressure(store.component(Field::position, 0)[i]);
      }
      auto const pairs = make_pair_backend(dimension, flavour, SchemeName::liquid,
                                           sweep_parameters(model), reference_densities(model));
      pairs->gather_fluid(store, search, 0.0);
      pairs->gather_walls(store, search, model.walls);
      // Rounding of a weighted mean, of 24 and of 53 bits; positions are rounded to 1e-10 m.
      double const tolerance = 5e3 * (flavour == Flavour::mixed ? 1e-6 : 1e-13);
      ASSERT_FALSE(search.wet_walls().empty());
      int compared = 0;
      for (std::uint32_t const w : search.wet_walls()) {
        std::size_t const k = store.range(Kind::wall).begin + w;
        if (store.scalar(Field::density)[k] == 1000.0 && store.scalar(Field::pressure)[k] == 0.0)
          continue;  // in a list for its skin only
        EXPECT_NEAR(store.scalar(Field::pressure)[k],
                    pressure(store.component(Field::position, 0)[k]), tolerance);
        EXPECT_NEAR(store.scalar(Field::density)[k], rho_0, 1e-6 * rho_0);
        ++compared;
      }
      EXPECT_GT(compared, dimension == 1 ? 3 : 20);
    }
}

}  // namespace
}  // namespace moraine
