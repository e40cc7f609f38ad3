// Mirror walls: images, force, momentum and energy.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "setup/build_model.hpp"
#include "setup/mirror_walls.hpp"
#include "setup/wall_parts.hpp"
#include "step/simulation_setup.hpp"
#include "support/charge_in_box.hpp"
#include "support/memory_archive.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

using charge::charge_in_box;
using charge::spacing;

double scale_of_momentum(ConservedSums const& s) {
  return std::sqrt(2.0 * s.mass * s.kinetic_energy);
}

struct Setting {
  int dimension, side;
  WallMethod method;
  Slip slip;
};

class MirrorWalls : public testing::TestWithParam<Setting> {};

// Walls at rest do no work; what they push is what the fluid gains. Both to the accuracy of the
// step: momentum to rounding, energy to second order in the step.
TEST_P(MirrorWalls, TellTheirImpulseAndKeepTheEnergy) {
  auto const [dimension, side, method, slip] = GetParam();
  Case const c = charge_in_box(dimension, side, method, slip);
  auto const drift = [&](int halvings) {
    Model model = build_model(c);
    EXPECT_EQ(model.particles.range(Kind::wall).size(), 0u);
    stir(model, 200.0);
    model.time.fixed_step = std::ldexp(2e-7, -halvings);
    Simulation simulation(std::move(model));
    ConservedSums const before = simulation.sums();
    for (int step = 0; step < 60 << halvings; ++step) simulation.advance();
    ConservedSums const after = simulation.sums();
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
      EXPECT_NEAR(after.momentum[k] - before.momentum[k], after.wall_impulse[k],
                  1e-11 * scale_of_momentum(after));
      EXPECT_GT(std::fabs(after.wall_impulse[k]), 1e-4 * scale_of_momentum(after));
    }
    EXPECT_EQ(simulation.lost().count, 0u);
    return std::fabs(after.total_energy() - before.total_energy()) / after.kinetic_energy;
  };
  double const coarse = drift(0), fine = drift(1);
  EXPECT_LE(coarse, 5e-3);  // of a charge that goes off among particles that were stirred
  EXPECT_LE(fine, 0.35 * coarse + 1e-9);  // a quarter, where the error is all of second order
}

INSTANTIATE_TEST_SUITE_P(, MirrorWalls,
                         testing::Values(Setting{1, 60, WallMethod::mirror, Slip::free},
                                         Setting{2, 24, WallMethod::mirror, Slip::free},
                                         Setting{2, 24, WallMethod::mirror, Slip::none},
                                         Setting{3, 12, WallMethod::mirror, Slip::free},
                                         Setting{3, 12, WallMethod::mirror, Slip::none},
                                         Setting{2, 24, WallMethod::mirror_and_repulsive,
                                                 Slip::free}));

/// Energy gained by a stirred charge between mirrors without slip, by its kinetic energy.
double gain_with_options(void (*ask)(Numerics&), double viscosity, int halvings) {
  Model model = build_model(charge_in_box(2, 24, WallMethod::mirror, Slip::none));
  ask(model.numerics);
  for (Material& material : model.materials) material.dynamic_viscosity = viscosity;
  stir(model, 200.0);
  model.time.fixed_step = std::ldexp(2e-7, -halvings);
  Simulation simulation(std::move(model));
  double const before = simulation.sums().total_energy();
  for (int step = 0; step < 60 << halvings; ++step) simulation.advance();
  ConservedSums const after = simulation.sums();
  return std::fabs(after.total_energy() - before) / after.kinetic_energy;
}

// What optional terms push, walls at rest do no work with either: only the error of the step is
// left.
TEST(MirrorWall, OptionsKeepTheEnergyWithoutSlip) {
  for (auto const& [ask, viscosity] :
       {std::pair{+[](Numerics& n) { n.physical_viscosity = ViscosityForm::monaghan_cleary; }, 1e4},
        std::pair{+[](Numerics& n) { n.physical_viscosity = ViscosityForm::morris; }, 1e4},
        std::pair{+[](Numerics& n) { n.gradient_correction = GradientCorrection::bonet_lok; },
                  0.0}}) {
    double const coarse = gain_with_options(ask, viscosity, 0);
    double const fine = gain_with_options(ask, viscosity, 1);
    EXPECT_LE(coarse, 5e-3);
    EXPECT_LE(fine, 0.35 * coarse + 1e-9);
  }
}

// A drop that falls on a mirror again and again turns round in the step in which it passes, so that
// gravity has no time to pull at it beyond: it never comes higher than it fell from. What is left
// is g dt of velocity at each of 20 bounces, against the 1.4 m/s of the fall.
TEST(MirrorWall, ADropThatBouncesGainsNothing) {
  Case c = charge_in_box(2, 24, WallMethod::mirror, Slip::free);
  Tait water;
  water.reference_sound_speed = 0.01;  // so soft that its image does not stop it
  c.numerics.viscosity_alpha = 0.0;
  c.numerics.viscosity_beta = 0.0;
  c.materials = {{"water", water}};
  c.regions = {{"drop", "water", Box{{0.1, 0.1, 0.0}, {0.1 + spacing, 0.1 + spacing, 0.0}}, {}}};
  c.gravity = {0.0, -9.81, 0.0};
  c.time.fixed_step = 1e-4;
  c.time.end = 5.7;
  c.guards.off = {"budget", "density"};
  Simulation simulation(build_model(c));
  double const start = simulation.particles().component(Field::position, 1)[0];
  double const energy = simulation.sums().total_energy();
  double const mass = simulation.sums().mass;
  double highest = 0.0;
  while (simulation.running()) {
    simulation.advance();
    double const z = simulation.particles().component(Field::position, 1)[0];
    ASSERT_GE(z, 0.0);
    highest = std::max(highest, z);
  }
  EXPECT_GE(simulation.search().reflections().count, 19u);
  EXPECT_LE(highest, 1.01 * start);
  EXPECT_NEAR(simulation.sums().total_energy() / energy, 1.0, 0.01);
  EXPECT_NEAR(simulation.sums().wall_impulse[1],
              simulation.sums().momentum[1] + mass * 9.81 * simulation.time(), 1e-9 * mass);
}

/// The search and the records of a box of side 8 whose walls reflect.
struct Gathered {
  Model model;
  Search search;
};
Gathered gathered(Slip slip) {
  Model model = build_model(charge_in_box(3, 12, WallMethod::mirror, slip));
  Search search(search_settings(model));
  search.refresh(model.particles);
  return {std::move(model), std::move(search)};
}

// A particle in a corner has seven images: one across each face, edge and the corner itself.
TEST(MirrorWall, CornersHaveAllImages) {
  Gathered const g = gathered(Slip::free);
  ParticleStore const& store = g.model.particles;
  std::size_t const owned = store.range(Kind::fluid).size();
  auto const& images = g.search.images(Kind::fluid);
  for (std::size_t i = 0; i < owned; ++i) {
    bool in_corner = true;
    for (int axis = 0; axis < 3; ++axis)
      in_corner = in_corner && store.component(Field::position, axis)[i] < spacing;
    if (!in_corner) continue;
    std::set<std::array<std::int8_t, 3>> octants;
    for (Image const& image : images)
      if (image.source == i) octants.insert(image.shift);
    EXPECT_EQ(octants.size(), 7u);
    // They are neighbours in the list of images at walls and in no other.
    std::size_t own = 0;
    for (std::uint32_t const j : g.search.fluid_mirrored().points(i)) {
      ASSERT_GE(j, owned);
      own += images[j - owned].source == i ? 1 : 0;
    }
    EXPECT_EQ(own, 7u);
    for (std::uint32_t const j : g.search.fluid_fluid().points(i)) EXPECT_LT(j, owned);
    return;
  }
  FAIL() << "no particle in the corner";
}

// Still water of one pressure between mirrors is an endless lattice: nothing moves at all.
TEST(MirrorWall, FullTankAtRestStaysAtRest) {
  for (Slip const slip : {Slip::free, Slip::none})
    for (int const dimension : {1, 2, 3}) {
      Case c = charge_in_box(dimension, dimension == 1 ? 60 : 12, WallMethod::mirror, slip);
      c.regions.pop_back();
      c.regions[0].initial.pressure = 5e6;
      Simulation simulation(build_model(c));
      for (int step = 0; step < 100; ++step) simulation.advance();
      // A Courant step of the sound would carry water of this pressure at 3 m/s; rounding only.
      for (int axis = 0; axis < dimension; ++axis)
        EXPECT_LE(largest(simulation.particles(), Field::velocity, axis), 1e-8);
    }
}

// Loads that gauges read are the force that the sweep puts on the fluid, and torques those of the
// forces on the particles.
TEST(MirrorWall, LoadsAddUpToTheForceOnTheFluid) {
  for (WallMethod const method : {WallMethod::mirror, WallMethod::mirror_and_repulsive}) {
    Case const c = charge_in_box(2, 24, method, Slip::none);
    Model start = build_model(c);
    stir(start, 300.0);
    Simulation simulation(std::move(start));
    for (int step = 0; step < 40; ++step) simulation.advance();
    auto const before = simulation.sums().wall_impulse;
    double const dt = simulation.time_step();
    auto const read = [&] {
      Model const& model = simulation.model();
      std::vector<WallLoad> loads;
      std::vector<MirrorLoad> mirror_loads;
      simulation.pairs().loads_on_walls(simulation.particles(), simulation.search(), loads);
      simulation.pairs().loads_on_mirrors(simulation.particles(), simulation.search(),
                                          mirror_loads);
      return probe_wall({simulation.particles(), simulation.search(), model.walls, loads,
                         model.gravity, spacing, model.symmetry, model.domain_min, model.domain_max,
                         mirror_loads, model.numerics.smoothing_length(), model.numerics.kernel},
                        {wall_members(c, c.gauges[0]), {}, face_parts(c, c.gauges[0])});
    };
    WallReading const first = read();
    auto const reflected = simulation.search().reflections().impulse;
    simulation.advance();
    WallReading const second = read();
    EXPECT_NEAR(second.wet_area, 4 * 24 * spacing, 1e-12);
    double const size = 1e8 * second.wet_area;
    for (std::size_t k = 0; k < 2; ++k) {
      double const impulse = simulation.sums().wall_impulse[k] - before[k] -
                             (simulation.search().reflections().impulse[k] - reflected[k]);
      EXPECT_NEAR(-0.5 * (first.force[k] + second.force[k]), impulse / dt, 1e-9 * size);
      EXPECT_GT(std::fabs(second.force[k]), 1e-3 * size);
    }
  }
}

// At a no-slip wall a sheared stream feels its image, which runs the other way: it loses momentum
// along the wall. At a free-slip wall it does not.
TEST(MirrorWall, NoSlipDragsAndFreeSlipDoesNot) {
  for (Slip const slip : {Slip::free, Slip::none}) {
    Case c = charge_in_box(2, 24, WallMethod::mirror, slip);
    c.regions.pop_back();
    c.regions[0].initial.velocity = {30.0, 0.0, 0.0};
    c.periodic[0] = true;
    c.domain.min[0] = 0.0;
    c.domain.max[0] = 24 * spacing;
    Simulation simulation(build_model(c));
    double const before = simulation.sums().momentum[0];
    for (int step = 0; step < 100; ++step) simulation.advance();
    double const lost = 1.0 - simulation.sums().momentum[0] / before;
    if (slip == Slip::free)
      EXPECT_NEAR(lost, 0.0, 1e-11);
    else
      EXPECT_GT(lost, 1e-3);
  }
}

std::vector<double> after_steps(int threads) {
  int const before = omp_get_max_threads();
  omp_set_num_threads(threads);
  Case c = charge_in_box(2, 32, WallMethod::mirror_and_repulsive, Slip::none);
  c.numerics.precision = Precision::mixed;
  Simulation simulation(build_model(c));
  for (int step = 0; step < 80; ++step) simulation.advance();
  omp_set_num_threads(before);
  auto state = state_by_id(simulation.particles());
  ConservedSums const sums = simulation.sums();
  state.insert(state.end(), {sums.wall_impulse[0], sums.potential_energy});
  return state;
}

TEST(MirrorWall, SameBitsForAnyNumberOfThreads) { EXPECT_EQ(after_steps(1), after_steps(3)); }

TEST(MirrorWall, GoesOnAsIfItHadNotStopped) {
  Case c = charge_in_box(2, 32, WallMethod::mirror_and_repulsive, Slip::free);
  c.numerics.precision = Precision::mixed;
  c.time.fixed_step = 0.0;
  Simulation straight(build_model(c));
  for (int step = 0; step < 50; ++step) straight.advance();
  MemoryArchive saved;
  straight.save(saved);
  saved.restore();
  Simulation resumed(build_model(c), saved);
  for (int step = 0; step < 40; ++step) {
    straight.advance();
    resumed.advance();
  }
  EXPECT_EQ(state_by_id(straight.particles()), state_by_id(resumed.particles()));
  EXPECT_EQ(straight.sums().wall_impulse, resumed.sums().wall_impulse);
  EXPECT_EQ(straight.sums().total_energy(), resumed.sums().total_energy());
}

}  // namespace
}  // namespace moraine
