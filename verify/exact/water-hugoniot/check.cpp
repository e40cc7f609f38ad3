// Shocks in water: a block that is thrown against a rigid wall.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "exact/hugoniot.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double length = 1.0;  // m, of the block

/// One metre of water with velocity -u in front of a wall at x = 0.
Case thrown_block(double u, double spacing) {
  Case c;
  c.dimension = 1;
  c.domain = {{-length, 0.0, 0.0}, {2.0 * length, 0.0, 0.0}};
  c.numerics.spacing = spacing;
  c.numerics.precision = Precision::full;
  c.time.end = 1.0;  // never reached
  c.materials = {{"water", WaterPolynomial{}}};
  RegionSpec block{"block", "water", Box{{0.0, 0.0, 0.0}, {length, 0.0, 0.0}}, {}};
  block.initial.velocity = {-u, 0.0, 0.0};
  c.regions = {block};
  WallSpec wall;
  wall.name = "target";
  wall.box = {{0.0, 0.0, 0.0}, {2.0 * length, 0.0, 0.0}};
  wall.open[0][1] = true;
  c.walls = {wall};
  return c;
}

/// Pressure of the particles from the wall outwards.
std::vector<std::pair<double, double>> profile(Simulation const& simulation) {
  ParticleStore const& store = simulation.particles();
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    points.emplace_back(store.component(Field::position, 0)[i], store.scalar(Field::pressure)[i]);
  std::sort(points.begin(), points.end());
  return points;
}

/// Farthest place where the pressure crosses `level`; 0 if it does nowhere.
double crossing(Simulation const& simulation, double level) {
  auto const points = profile(simulation);
  for (std::size_t k = points.size() - 1; k > 0; --k) {
    auto const [x, p] = points[k - 1];
    auto const [x_next, p_next] = points[k];
    if (p >= level && p_next < level) return x + (x_next - x) * (p - level) / (p - p_next);
  }
  return 0.0;
}

/// Mean of a field over the middle part of the shocked water.
double mean_behind(Simulation const& simulation, Field field, double shock) {
  ParticleStore const& store = simulation.particles();
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    if (x < 0.3 * shock || x > 0.7 * shock) continue;
    sum += store.scalar(field)[i];
    count += 1.0;
  }
  return sum / count;
}

void add_results(double u, double spacing, std::vector<CheckResult>& results) {
  WaterPolynomial const water;
  double const p_0 = water.pressure(water.reference_density, water.reference_energy);
  ShockState const exact =
      shock_from_piston(water, water.reference_density, water.reference_energy, u);
  Simulation simulation(build_model(thrown_block(u, spacing)));
  double const level = 0.5 * (p_0 + exact.pressure);
  auto const run_to = [&](double shock) {
    while (simulation.running() && crossing(simulation, level) < shock) simulation.advance();
    return std::pair(simulation.time(), crossing(simulation, level));
  };
  // Before 0.4 of the block is shocked, the release wave from its free end is not met yet.
  auto const [t_1, x_1] = run_to(0.15 * length);
  auto const [t_2, x_2] = run_to(0.4 * length);
  double const speed = (x_2 - x_1) / (t_2 - t_1) + u;  // into water at rest
  auto const add = [&](char const* what, double measured, double reference, char const* unit) {
    results.push_back(compare(fmt::format("water-hugoniot: {} at {:g} m/s", what, u), measured,
                              reference, 0.03 * reference, unit, "exact: jump conditions"));
  };
  add("shock speed", speed, exact.shock_speed, "m/s");
  add("pressure jump", mean_behind(simulation, Field::pressure, x_2) - p_0, exact.pressure - p_0,
      "Pa");
  add("density jump", mean_behind(simulation, Field::density, x_2) - water.reference_density,
      exact.density - water.reference_density, "kg/m^3");
}

}  // namespace

std::vector<CheckResult> check_water_hugoniot(Effort effort) {
  std::vector<CheckResult> results;
  double const spacing = effort == Effort::quick ? 4e-3 : 2e-3;
  for (double const u : {100.0, 300.0, 1000.0}) add_results(u, spacing, results);
  return results;
}

}  // namespace moraine
