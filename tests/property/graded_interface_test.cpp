// What regions of other spacings do to waves that cross their faces, and to water at rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "setup/build_model.hpp"
#include "setup/geometry.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double amplitude = 1e4;  // Pa: 4e-6 of the water's bulk modulus, linear acoustics
constexpr double width = 0.08;     // m, standard deviation of the pulse
constexpr double start_at = -0.6;  // m

struct Liquid {
  double density;      // kg/m^3
  double sound_speed;  // m/s
  double impedance() const { return density * sound_speed; }
};
constexpr Liquid left{1000.0, 1500.0};
constexpr Liquid right{1630.0, 2000.0};

/// Two liquids that touch at x = 0, the right one with the masses of the left one, with so
/// little viscosity that the pulse loses 0.2 % of its peak.
Case two_liquids(double spacing) {
  Case c;
  c.dimension = 1;
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = 1.5;
  c.numerics.viscosity_alpha = 0.02;
  c.numerics.viscosity_beta = 0.0;
  c.numerics.continuity = ContinuityForm::volume;
  c.numerics.precision = Precision::full;
  auto const tait = [](Liquid const& liquid) {
    return Tait{.reference_density = liquid.density, .reference_sound_speed = liquid.sound_speed};
  };
  c.materials = {{"left", tait(left)}, {"right", tait(right)}};
  c.regions = {{"left", "left", Box{{-1.5, 0, 0}, {0, 0, 0}}, {}},
               {"right", "right", Box{{0, 0, 0}, {1.5, 0, 0}}, {}}};
  c.regions[1].equal_mass_with = "left";
  c.domain = *default_domain(c);
  c.time.end = 0.7e-3;
  return c;
}

/// A pulse that runs to the right: p = rho c u.
void add_pulse(Model& model) {
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = (store.component(Field::position, 0)[i] - start_at) / width;
    double const pressure = amplitude * std::exp(-0.5 * x * x);
    if (store.material()[i] != 0 || pressure < 1e-9 * amplitude) continue;
    store.scalar(Field::density)[i] += pressure / (left.sound_speed * left.sound_speed);
    store.component(Field::velocity, 0)[i] = pressure / left.impedance();
  }
}

struct Pulse {
  double peak = 0.0;  // Pa
  double sum = 0.0;   // Pa m, integral over x
};

Pulse pulse_on(Simulation const& simulation, MaterialId side) {
  ParticleStore const& store = simulation.particles();
  Pulse pulse;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    if (store.material()[i] != side) continue;
    // Away from the interface and from the free ends.
    double const x = std::abs(store.component(Field::position, 0)[i]);
    if (x < 0.05 || x > 1.4) continue;
    double const p = store.scalar(Field::pressure)[i];
    pulse.peak = std::max(pulse.peak, p);
    pulse.sum += p * store.scalar(Field::mass)[i] / store.scalar(Field::density)[i];
  }
  return pulse;
}

/// Largest difference from the exact shares, in parts of the pulse that came, of peaks and
/// integrals.
///
/// Transmission T = 2 Z_2 / (Z_1 + Z_2) and reflection R = (Z_2 - Z_1) / (Z_1 + Z_2) of pressure at
/// normal incidence: Kinsler, Frey, Coppens and Sanders, Fundamentals of Acoustics, chapter 6.
double error_of_shares(Case const& c) {
  double const sum = left.impedance() + right.impedance();
  double const transmitted = 2.0 * right.impedance() / sum;
  double const reflected = (right.impedance() - left.impedance()) / sum;
  double const area = amplitude * width * std::sqrt(2.0 * std::numbers::pi);
  Model model = build_model(c);
  add_pulse(model);
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  Pulse const ahead = pulse_on(simulation, 1);
  Pulse const back = pulse_on(simulation, 0);
  double const stretched = area * right.sound_speed / left.sound_speed;
  return std::max({std::abs(ahead.sum / stretched - transmitted),
                   std::abs(ahead.peak / amplitude - transmitted),
                   std::abs(back.sum / area - reflected),
                   std::abs(back.peak / amplitude - reflected)});
}

// Where the spacing changes and h does not, kernel sums are off by a share that no refinement takes
// away: measured 0.015. On one lattice the same measure gives 0.003.
TEST(GradedInterface, PassesOnTheShareOfAPulseToTwoPerCent) {
  Case c = two_liquids(2.5e-3);
  EXPECT_LT(error_of_shares(c), 0.02);
  c.regions[1].equal_mass_with.clear();
  EXPECT_LT(error_of_shares(c), 0.005);
}

/// Water in a closed box, its middle at half the spacing.
Case graded_water(double pressure) {
  Case c;
  c.dimension = 2;
  c.numerics.spacing = 0.05;
  c.numerics.precision = Precision::full;
  c.materials = {{"water", Tait{.reference_sound_speed = 30.0}}};
  c.regions = {{"sea", "water", Box{{-1, -1, 0}, {1, 1, 0}}, {}},
               {"middle", "water", Box{{-0.5, -0.5, 0}, {0.5, 0.5, 0}}, {}}};
  c.regions[1].spacing = 0.025;
  for (RegionSpec& region : c.regions) region.initial.pressure = pressure;
  c.walls = {{"box", WallForm::container, {{-1, -1, 0}, {1, 1, 0}}, {}, Slip::free}};
  c.domain = *default_domain(c);
  c.time.end = 0.2;  // sound crosses the box three times
  return c;
}

double fastest(Simulation const& simulation) {
  ParticleStore const& store = simulation.particles();
  double square = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    square = std::max(square, std::pow(store.component(Field::velocity, 0)[i], 2) +
                                  std::pow(store.component(Field::velocity, 1)[i], 2));
  return std::sqrt(square);
}

TEST(GradedWater, StaysExactlyAtRestWithoutPressure) {
  Simulation simulation(build_model(graded_water(0.0)));
  while (simulation.running()) simulation.advance();
  EXPECT_EQ(fastest(simulation), 0.0);
}

// The particles along the face rearrange themselves: measured 0.19 % of sqrt(p / rho), 6e-5 of the
// sound speed.
TEST(GradedWater, StaysNearlyAtRestUnderAPressureEqualEverywhere) {
  double const pressure = 900.0;  // Pa, rho c^2 / 1000
  Simulation simulation(build_model(graded_water(pressure)));
  double most = 0.0;
  while (simulation.running()) {
    simulation.advance();
    most = std::max(most, fastest(simulation));
  }
  EXPECT_LT(most, 0.003 * std::sqrt(pressure / 1000.0));
  EXPECT_GT(most, 0.0);
}

}  // namespace
}  // namespace moraine
