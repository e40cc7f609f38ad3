// Solids at walls: momentum, energy and shear.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "step/simulation_setup.hpp"
#include "support/charge_in_box.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

using charge::charge_in_box;
using Setting = std::tuple<int, WallMethod, Slip, MomentumForm>;

class SolidAtWalls : public testing::TestWithParam<Setting> {};

// A charge that goes off in a solid that yields: walls at rest do no work, and what they push is
// what the particles gain.
TEST_P(SolidAtWalls, KeepsMomentumAndEnergy) {
  auto const [dimension, method, slip, momentum] = GetParam();
  Case c = charge_in_box(dimension, dimension == 2 ? 24 : 12, method, slip);
  c.numerics.momentum = momentum;
  if (momentum == MomentumForm::mixed) c.numerics.continuity = ContinuityForm::volume;
  auto const drift = [&](int halvings) {
    Model model = with_strength(build_model(c));
    stir(model, 200.0);
    model.time.fixed_step = std::ldexp(2e-7, -halvings);
    Simulation simulation(std::move(model));
    ConservedSums const before = simulation.sums();
    for (int step = 0; step < 60 << halvings; ++step) simulation.advance();
    ConservedSums const after = simulation.sums();
    double const scale = std::sqrt(2.0 * after.mass * after.kinetic_energy);
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
      EXPECT_NEAR(after.momentum[k] - before.momentum[k], after.wall_impulse[k], 1e-11 * scale);
    EXPECT_GT(largest(simulation.particles(), Field::deviatoric_stress, 0), 1e6);
    return std::fabs(after.total_energy() - before.total_energy()) / after.kinetic_energy;
  };
  double const coarse = drift(0), fine = drift(1);
  EXPECT_LE(coarse, 5e-3);
  EXPECT_LE(fine, 0.5 * coarse + 1e-9);  // of first order where it yields, else of second
}

std::string name_of(testing::TestParamInfo<Setting> const& variant) {
  auto const [dimension, method, slip, momentum] = variant.param;
  return std::to_string(dimension) + (method == WallMethod::dummy ? "d_dummy" : "d_mirror") +
         (slip == Slip::free ? "_free" : "_none") +
         (momentum == MomentumForm::mixed ? "_mixed" : "");
}

INSTANTIATE_TEST_SUITE_P(
    , SolidAtWalls,
    testing::Combine(testing::Values(2, 3), testing::Values(WallMethod::dummy, WallMethod::mirror),
                     testing::Values(Slip::free, Slip::none),
                     testing::Values(MomentumForm::conservative, MomentumForm::mixed)),
    name_of);

/// Force of a floor, one metre long, on a solid with the shear stress s_xy = 1 kPa everywhere.
Vec3 force_of_floor(WallMethod method, Slip slip) {
  Case c;
  c.dimension = 2;
  c.domain = {{0.0, method == WallMethod::mirror ? 0.0 : -1.0, 0.0}, {1.0, 2.0, 0.0}};
  c.periodic[0] = true;
  c.numerics.spacing = 0.02;
  c.numerics.precision = Precision::full;
  c.time.end = 1.0;
  MaterialSpec soil{.name = "soil", .eos = Linear{}};
  soil.strength = {.kind = StrengthKind::elastic, .shear_modulus = 1e6};
  c.materials = {soil};
  c.regions = {{"soil", "soil", Box{{0.0, 0.0, 0.0}, {1.0, 0.5, 0.0}}, {}}};
  WallSpec wall;
  wall.name = "floor";
  wall.box = {{0.0, 0.0, 0.0}, {1.0, 2.0, 0.0}};
  wall.open[0][0] = wall.open[0][1] = wall.open[1][1] = true;
  wall.slip = slip;
  wall.method = method;
  c.walls = {wall};
  Model model = build_model(c);
  ParticleStore& store = model.particles;
  for (double& shear : store.component(Field::predicted_stress, 2)) shear = 1e3;
  Search search(search_settings(model));
  search.refresh(store);
  for (std::size_t k = store.range(Kind::wall).begin; k < store.size(); ++k)
    store.scalar(Field::density)[k] = 1000.0;
  auto const backend = make_strength_of(model);
  backend->gather(store, search, model.walls, 0.0);
  return backend->sweep(store, search).wall_force;
}

// The solid pulls the floor along where it sticks: with s_xy times the length, to what the lattice
// makes of the integral of the kernel. Where it slips there is no shear.
TEST(SolidOnFloor, ShearPassesOnlyWhereItSticks) {
  for (WallMethod const method : {WallMethod::dummy, WallMethod::mirror}) {
    Vec3 const sticks = force_of_floor(method, Slip::none);
    EXPECT_NEAR(sticks[0], -1e3, 60.0);
    EXPECT_NEAR(sticks[1], 0.0, 1e-9);
    Vec3 const slips = force_of_floor(method, Slip::free);
    EXPECT_NEAR(slips[0], 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace moraine
