// Absorbing layers: what comes back of a wave that runs into one.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double speed = 1500.0;  // m/s
constexpr double rho = 1000.0;    // kg/m^3

/// One metre of a linear fluid or solid in 1D; a pulse runs from its middle to the right.
Model bar(bool absorbs, bool solid) {
  Case c;
  c.dimension = 1;
  c.domain = {{-1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  c.numerics.spacing = 5e-3;
  c.numerics.viscosity_alpha = c.numerics.viscosity_beta = 0.0;
  c.numerics.precision = Precision::full;
  c.time.end = 1.0 / speed;
  Linear law;
  law.reference_density = rho;
  law.reference_sound_speed = speed;
  law.least_pressure = -std::numeric_limits<double>::infinity();
  MaterialSpec material{.name = "bar", .eos = law};
  if (solid) material.strength = {.kind = StrengthKind::elastic, .shear_modulus = 1e9};
  c.materials = {material};
  c.regions = {{"bar", "bar", Box{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {}}};
  WallSpec wall;
  wall.name = "ends";
  wall.box = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  c.walls = {wall};
  if (absorbs) {
    c.absorbing.sides[0][1] = true;
    c.absorbing.thickness = 0.3;
  }
  Model model = build_model(c);
  ParticleStore& store = model.particles;
  double const stiffness = rho * speed * speed + (solid ? 4.0 / 3.0 * 1e9 : 0.0);
  double const c_l = std::sqrt(stiffness / rho);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    double const pulse = 1e-3 * std::exp(-std::pow((x - 0.35) / 0.06, 2));
    store.component(Field::velocity, 0)[i] = c_l * pulse;
    store.scalar(Field::density)[i] = rho * (1.0 + pulse);
    if (solid) store.component(Field::deviatoric_stress, 0)[i] = -4.0 / 3.0 * 1e9 * pulse;
  }
  return model;
}

/// Largest speed before the layer once the pulse has been at the end and back, by that of the
/// start.
double comes_back(bool absorbs, bool solid) {
  Simulation simulation(bar(absorbs, solid));
  double first = 0.0, last = 0.0;
  auto const fastest = [&] {
    double most = 0.0;
    ParticleStore const& store = simulation.particles();
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
      if (store.component(Field::position, 0)[i] < 0.7)
        most = std::max(most, std::fabs(store.component(Field::velocity, 0)[i]));
    return most;
  };
  first = fastest();
  while (simulation.running()) simulation.advance();
  last = fastest();
  return last / first;
}

TEST(AbsorbingLayer, LetsLittleOfAPulseComeBack) {
  EXPECT_GT(comes_back(false, false), 0.9) << "the wall behind reflects";
  EXPECT_LT(comes_back(true, false), 0.01);
}

TEST(AbsorbingLayer, AbsorbsStressWavesOfASolid) { EXPECT_LT(comes_back(true, true), 0.01); }

TEST(AbsorbingLayer, BooksWhatItTakes) {
  Simulation simulation(bar(true, false));
  auto const balance = [&] {
    return energy_balance(simulation.sums(), simulation.lost(), simulation.booked());
  };
  double const start = balance();
  double const kinetic = simulation.sums().kinetic_energy;
  while (simulation.running()) simulation.advance();
  EXPECT_LT(simulation.booked().damping, -0.2 * kinetic);
  EXPECT_NEAR(balance(), start, 0.01 * kinetic);
}

/// Sand with pores in 1D, up to x = `length`, with a pulse of 20 m/s that crushes pores and runs to
/// the right from x = 0.35 m; after 3 ms.
Simulation crushed_sand(double length, bool absorbs) {
  Case c;
  c.dimension = 1;
  c.domain = {{-1.0, 0.0, 0.0}, {4.0, 0.0, 0.0}};
  c.numerics.spacing = 5e-3;
  c.numerics.precision = Precision::full;
  c.time.end = 3e-3;
  PAlpha law;
  law.reference_density = 1674.0;
  law.reference_sound_speed = 265.0;
  law.elastic_limit = 0.0;
  law.full_compaction_pressure = 1.77e9;
  law.crush_exponent = 1.0;
  law.half_pressure = 44e6;
  c.materials = {{"sand", law}};
  c.regions = {{"sand", "sand", Box{{0.0, 0.0, 0.0}, {length, 0.0, 0.0}}, {}}};
  WallSpec wall;
  wall.name = "ends";
  wall.box = {{0.0, 0.0, 0.0}, {length, 0.0, 0.0}};
  c.walls = {wall};
  if (absorbs) {
    c.absorbing.sides[0][1] = true;
    c.absorbing.thickness = 0.3;
  }
  Model model = build_model(c);
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    store.component(Field::velocity, 0)[i] = 20.0 * std::exp(-std::pow((x - 0.35) / 0.06, 2));
  }
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  return simulation;
}

/// Largest difference of speed before x = 0.65 m from that in sand that goes on for long; the pulse
/// arrives at the layer with 5.2 m/s.
double comes_back_in_sand(bool absorbs) {
  Simulation const endless = crushed_sand(3.0, false), ends = crushed_sand(1.0, absorbs);
  std::map<std::uint64_t, double> expected;
  ParticleStore const& far = endless.particles();
  for (std::size_t i = 0; i < far.range(Kind::fluid).size(); ++i)
    expected[far.id()[i]] = far.component(Field::velocity, 0)[i];
  double most = 0.0;
  ParticleStore const& store = ends.particles();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (store.component(Field::position, 0)[i] < 0.65)
      most = std::max(
          most, std::fabs(store.component(Field::velocity, 0)[i] - expected.at(store.id()[i])));
  return most;
}

TEST(AbsorbingLayer, AbsorbsWavesThatCrushPores) {
  double const wall = comes_back_in_sand(false), layer = comes_back_in_sand(true);
  EXPECT_GT(wall, 0.15 * 5.2) << "the wall behind reflects, and the way back damps";
  EXPECT_LT(layer, 0.02 * 5.2);
}

// Products that burst into the space of a layer are left alone, and so is what began elsewhere.
TEST(AbsorbingLayer, LeavesAloneWhatComesBy) {
  Case c;
  c.dimension = 2;
  c.domain = {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}};
  c.numerics.spacing = 0.02;
  c.numerics.continuity = ContinuityForm::volume;
  c.time.end = 3e-4;
  c.materials = {{"ground", WaterPolynomial{}}, {"tnt", Jwl{}}};
  c.regions = {{"ground", "ground", Box{{0.0, 0.0, 0.0}, {1.0, 0.3, 0.0}}, {}},
               {"charge", "tnt", Box{{0.3, 0.3, 0.0}, {0.4, 0.4, 0.0}}, {}}};
  c.absorbing.sides[0][1] = true;
  c.absorbing.thickness = 0.4;
  Model model = build_model(c);
  EXPECT_NEAR(*model.absorbing.ends[0][1], 1.0, 1e-12);
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  ParticleStore const& store = simulation.particles();
  int came_by = 0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    if (store.material()[i] != 1) continue;
    EXPECT_EQ(store.scalar(Field::rest_density)[i], 0.0);
    if (store.component(Field::position, 0)[i] < 0.7) continue;
    ++came_by;
    EXPECT_GT(store.component(Field::velocity, 0)[i], 1000.0) << "in the middle of the layer";
  }
  EXPECT_GT(came_by, 0);
}

}  // namespace
}  // namespace moraine
