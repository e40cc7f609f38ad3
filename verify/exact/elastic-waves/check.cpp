// Waves of compression and of shear in an elastic solid.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double youngs_modulus = 5.84e6;  // Pa
constexpr double poissons_ratio = 0.3;
constexpr double density = 2040.0;   // kg/m^3
constexpr double wave_length = 1.0;  // m
constexpr double amplitude = 1e-3;   // m/s
double const bulk_modulus = youngs_modulus / (3.0 * (1.0 - 2.0 * poissons_ratio));
double const shear_modulus_of_soil = youngs_modulus / (2.0 * (1.0 + poissons_ratio));

Case block(int dimension, int spacings) {
  Case c;
  c.dimension = dimension;
  c.numerics.spacing = wave_length / spacings;
  c.numerics.smoothing_factor = 1.5;
  c.numerics.viscosity_alpha = c.numerics.viscosity_beta = 0.0;
  c.numerics.precision = Precision::full;
  double const across = 8.0 * c.numerics.spacing;
  c.domain = {{0.0, 0.0, 0.0}, {wave_length, across, dimension == 3 ? across : 0.0}};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    c.periodic[axis] = true;
  c.time.end = 1.0;  // never reached
  Linear pressure;
  pressure.reference_density = density;
  pressure.reference_sound_speed = std::sqrt(bulk_modulus / density);
  pressure.least_pressure = -std::numeric_limits<double>::infinity();
  MaterialSpec soil{.name = "soil", .eos = pressure};
  soil.strength = {.kind = StrengthKind::elastic, .shear_modulus = shear_modulus_of_soil};
  c.materials = {soil};
  c.regions = {{"soil", "soil", Box{c.domain.min, c.domain.max}, {}}};
  return c;
}

struct WaveResult {
  double speed = 0.0;   // m/s
  double energy = 0.0;  // gained, by that of the wave
};

/// `along`: axis of the velocity, 0 for compression, 1 for shear.
WaveResult run_wave(Case const& c, int along) {
  double const k = 2.0 * std::numbers::pi / wave_length;
  Model model = build_model(c);
  ParticleStore& start = model.particles;
  for (std::size_t i = 0; i < start.range(Kind::fluid).size(); ++i)
    start.component(Field::velocity, along)[i] =
        amplitude * std::sin(k * start.component(Field::position, 0)[i]);
  Simulation simulation(std::move(model));
  auto const swing = [&] {
    ParticleStore const& store = simulation.particles();
    double sum = 0.0;
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
      sum += store.component(Field::velocity, along)[i] *
             std::sin(k * store.component(Field::position, 0)[i]);
    return sum;
  };
  ConservedSums const before = simulation.sums();
  std::vector<double> zeros;  // s
  double last = swing();
  while (zeros.size() < 2 && simulation.running()) {
    double const from = simulation.time();
    simulation.advance();
    double const now = swing();
    if ((now > 0.0) != (last > 0.0))
      zeros.push_back(from + (simulation.time() - from) * last / (last - now));
    last = now;
  }
  double const gained = simulation.sums().total_energy() - before.total_energy();
  return {wave_length / (2.0 * (zeros.at(1) - zeros.at(0))), gained / before.kinetic_energy};
}

/// Speeds of both waves; returns the energy errors of them.
std::array<double, 2> add_speeds(int dimension, int spacings, double tolerance,
                                 std::vector<CheckResult>& results) {
  std::array<double, 2> energies{};
  double const of_waves[2] = {
      std::sqrt((bulk_modulus + 4.0 / 3.0 * shear_modulus_of_soil) / density),
      std::sqrt(shear_modulus_of_soil / density)};
  for (int along = 0; along < 2; ++along) {
    WaveResult const wave = run_wave(block(dimension, spacings), along);
    double const exact = of_waves[along];
    std::string const name = fmt::format("elastic-waves: {} wave in {}D, {} spacings",
                                         along == 0 ? "P" : "S", dimension, spacings);
    results.push_back(compare(name, wave.speed, exact, tolerance * exact, "m/s",
                              "speed of a standing wave; exact: elastic constants"));
    energies[static_cast<std::size_t>(along)] = std::fabs(wave.energy);
  }
  return energies;
}

}  // namespace

std::vector<CheckResult> check_elastic_waves(Effort effort) {
  std::vector<CheckResult> results;
  auto const coarse = add_speeds(2, 40, 0.02, results);
  if (effort == Effort::quick) return results;
  add_speeds(2, 20, 0.08, results);
  auto const fine = add_speeds(2, 80, 0.005, results);
  add_speeds(3, 40, 0.02, results);
  for (std::size_t along = 0; along < 2; ++along)
    results.push_back(compare(
        fmt::format("elastic-waves: order of the energy error, {} wave", along == 0 ? "P" : "S"),
        std::log2(coarse[along] / fine[along]), 2.0, 0.3, "-",
        fmt::format("in the time step; {:.2g} of the wave's energy at 80 spacings", fine[along])));
  return results;
}

}  // namespace moraine
