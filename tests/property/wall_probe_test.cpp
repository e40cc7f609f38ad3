// Loads on walls: against the force that the pair sweep puts on the fluid, and in water at rest.
#include <gtest/gtest.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <string>

#include "output/probe_recorder.hpp"
#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation_setup.hpp"
#include "support/small_models.hpp"
#include "support/tank_with_block.hpp"

namespace moraine {
namespace {

constexpr double rho_0 = 1000.0;  // kg/m^3
constexpr double g = 9.81;        // m/s^2

struct Loads {
  SweepOutcome swept;
  std::vector<WallLoad> loads;
  double size = 0.0;  // sum of the sizes of all loads [N]
};

Loads loads_of(int dimension, Flavour flavour, SchemeName scheme, int threads) {
  RandomBox box;
  box.dimension = dimension;
  box.side = std::array{0, 100, 24, 10}[static_cast<std::size_t>(dimension)];
  box.scheme = scheme;
  Model model = walled_random_box(box, 1.0);
  Search search(search_settings(model));
  search.refresh(model.particles);
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    store.scalar(Field::pressure)[i] = 1e4 * (1.5 + std::sin(static_cast<double>(i)));
    store.scalar(Field::sound_speed)[i] = 100.0;
  }
  auto const pairs = make_pair_backend(dimension, flavour, scheme, sweep_parameters(model),
                                       reference_densities(model));
  pairs->gather_fluid(store, search, 0.0);
  pairs->gather_walls(store, search, model.walls);
  int const before = omp_get_max_threads();
  omp_set_num_threads(threads);
  Loads result;
  result.swept = pairs->sweep(store, search);
  pairs->loads_on_walls(store, search, result.loads);
  omp_set_num_threads(before);
  for (WallLoad const& load : result.loads) result.size += norm(load.force);
  return result;
}

struct Variant {
  int dimension;
  Flavour flavour;
  SchemeName scheme;
};

class WallLoads : public testing::TestWithParam<Variant> {};

// Sides that are not walls repeat, so images of fluid and of wall particles take part.
TEST_P(WallLoads, AddUpToTheForceOfTheSweep) {
  auto const [dimension, flavour, scheme] = GetParam();
  Loads const found = loads_of(dimension, flavour, scheme, 2);
  Vec3 sum{};
  for (WallLoad const& load : found.loads) sum = add(sum, load.force);
  ASSERT_GT(found.size, 0.0);
  // The sweep rounds each pair to 24 or 53 bits; the loads are in double throughout.
  double const tolerance = found.size * (flavour == Flavour::mixed ? 2e-6 : 1e-14);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(sum[axis], -found.swept.wall_force[axis], tolerance) << "axis " << axis;
}

TEST_P(WallLoads, HaveTheSameBitsForAnyNumberOfThreads) {
  auto const [dimension, flavour, scheme] = GetParam();
  Loads const one = loads_of(dimension, flavour, scheme, 1);
  Loads const three = loads_of(dimension, flavour, scheme, 3);
  ASSERT_EQ(one.loads.size(), three.loads.size());
  for (std::size_t n = 0; n < one.loads.size(); ++n) {
    EXPECT_EQ(one.loads[n].force, three.loads[n].force);
    EXPECT_EQ(one.loads[n].wet, three.loads[n].wet);
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, WallLoads,
                         testing::Values(Variant{1, Flavour::full, SchemeName::compressible},
                                         Variant{2, Flavour::mixed, SchemeName::liquid},
                                         Variant{2, Flavour::full, SchemeName::liquid},
                                         Variant{2, Flavour::mixed, SchemeName::compressible},
                                         Variant{2, Flavour::reference, SchemeName::compressible},
                                         Variant{3, Flavour::mixed, SchemeName::liquid},
                                         Variant{3, Flavour::full, SchemeName::compressible}));

/// Readings of the gauges of a case at the state of a simulation.
class Readings {
 public:
  Readings(Case const& c, Simulation const& simulation) : probes_(c) {
    probes_.tell(simulation);
    row_ = probes_.read(simulation);
  }
  double operator[](std::string const& column) const {
    for (std::size_t k = 0; k < row_.size(); ++k)
      if (probes_.columns()[k].name == column) return row_[k];
    ADD_FAILURE() << "no column " << column;
    return 0.0;
  }

 private:
  ProbeRecorder probes_;
  std::vector<double> row_;
};

constexpr char const* tank = R"(
space.dimension = 2
physics.gravity = [0.0, -9.81]
resolution = { spacing = 0.02, smoothing_factor = 1.5 }
numerics = { viscosity_alpha = 0.1, viscosity_beta = 0.0, density_diffusion = 0.1 }
time.end = 0.5
material.water = { eos = "tait", reference_sound_speed = 31.3 }
[[region]]
name = "water"
material = "water"
hydrostatic_level = 0.5
box = { min = [0.0, 0.0], max = [1.0, 0.5] }
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [1.0, 0.8] }
open = ["y+"]
[[gauge]]
name = "all"
kind = "wall"
wall = "tank"
[[gauge]]
name = "left"
kind = "wall"
wall = "tank"
part = { min = [-0.01, 0.001], max = [0.01, 0.8] }
[[gauge]]
name = "right"
kind = "wall"
wall = "tank"
part = { min = [0.99, 0.001], max = [1.01, 0.8] }
about = [1.0, 0.1]
[[gauge]]
name = "bottom"
kind = "wall"
wall = "tank"
part = { min = [0.0, -0.01], max = [1.0, 0.0] }
)";

// Per metre of thickness: rho g H^2 / 2 on each side, the weight on the bottom. The water still
// swings a little after half a second, by some thousandths of its weight.
TEST(WallProbe, StillWaterPressesOnTheSidesAndItsWeightOnTheBottom) {
  Case const c = parse_case(tank, "tank");
  Simulation simulation(build_model(c));
  while (simulation.running()) simulation.advance();
  Readings const read(c, simulation);
  double const depth = 0.5;
  double const side = 0.5 * rho_0 * g * depth * depth;
  double const weight = g * simulation.sums().mass;
  // 25 rows of particles. The lowest rows share their load with the corner behind them, which
  // belongs to the bottom. Measured 1.7 % less than the whole.
  EXPECT_NEAR(-read["left force_x"], side, 0.03 * side);
  EXPECT_NEAR(read["right force_x"], side, 0.03 * side);
  EXPECT_NEAR(read["bottom force_y"], -weight, 0.01 * weight);
  // The triangle of pressure pushes H / 3 above the foot of the side.
  EXPECT_NEAR(read["right torque_z"], -side * (depth / 3.0 - 0.1), 0.03 * side * depth / 3.0);
  EXPECT_NEAR(read["bottom mean_pressure"], rho_0 * g * depth, 0.01 * rho_0 * g * depth);
  EXPECT_NEAR(read["bottom wet_area"], 1.0, 1e-9);
  // Above the water the wall is wet as far as the kernel reaches: there the mean has zeros in it.
  EXPECT_GT(read["left wet_area"], depth);
  EXPECT_NEAR(read["left mean_pressure"] * read["left wet_area"], side, 0.01 * side);
  // The parts are the whole.
  EXPECT_NEAR(read["left force_x"] + read["right force_x"] + read["bottom force_x"],
              read["all force_x"], 1e-12 * side);
  // Newton: what the walls do not bear, the water falls with; and the same for torques about the
  // origin, because the forces inside of the water turn nothing. Measured to 5e-8 and 3e-8.
  double fall = 0.0;
  double turn = 0.0;
  ParticleStore const& store = simulation.particles();
  auto const of = [&](Field field, int axis, std::size_t i) {
    return store.component(field, axis)[i];
  };
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const mass = store.scalar(Field::mass)[i];
    fall += mass * of(Field::acceleration, 1, i);
    turn += mass * (of(Field::position, 0, i) * (of(Field::acceleration, 1, i) + g) -
                    of(Field::position, 1, i) * of(Field::acceleration, 0, i));
  }
  EXPECT_NEAR(read["all force_y"], -weight - fall, 1e-6 * weight);
  EXPECT_NEAR(read["all torque_z"], -turn, 1e-6 * weight);
}

constexpr char const* gauges_at_block = R"([[gauge]]
name = "block"
kind = "wall"
wall = "block"
about = [0.5, 0.26]
[[gauge]]
name = "below"
kind = "wall"
wall = "block"
part = { min = [0.42, 0.15], max = [0.58, 0.17] }
)";

TEST(WallProbe, ABlockIsLiftedByTheWaterItDisplaces) {
  Case const c = parse_case(tank_with_block("0.3", gauges_at_block), "block");
  Simulation simulation(build_model(c));
  while (simulation.running()) simulation.advance();
  Readings const read(c, simulation);
  double const buoyancy = rho_0 * g * 0.2 * 0.2;
  // Archimedes; the block is ten spacings wide.
  EXPECT_NEAR(read["block force_y"], buoyancy, 0.01 * buoyancy);
  EXPECT_NEAR(read["block force_x"], 0.0, 1e-3 * buoyancy);
  EXPECT_NEAR(read["block torque_z"], 0.0, 1e-3 * buoyancy * 0.2);
  double const below = rho_0 * g * (0.6 - 0.16);
  EXPECT_NEAR(read["below mean_pressure"], below, 0.01 * below);
  EXPECT_NEAR(read["below wet_area"], 0.16, 1e-9);
}

}  // namespace
}  // namespace moraine
