// Shocks in water: a block that is thrown against a rigid wall.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <vector>

#include "exact/hugoniot.hpp"
#include "setup/build_model.hpp"
#include "verify/thrown_block.hpp"

namespace moraine {
namespace {

void add_results(double u, double spacing, std::vector<CheckResult>& results) {
  WaterPolynomial const water;
  double const rho = water.reference_density;
  double const p_0 = water.pressure(rho, water.reference_energy);
  ShockState const exact = shock_from_piston(water, rho, water.reference_energy, u);
  Simulation simulation(build_model(thrown_block({"water", water}, u, spacing)));
  double const level = 0.5 * (p_0 + exact.pressure);
  // Before 0.4 of the block is shocked, the release wave from its free end is not met yet.
  Passage const first = run_until(simulation, pressure_of, level, 0.15 * block_length);
  Passage const last = run_until(simulation, pressure_of, level, 0.4 * block_length);
  auto const behind = [&](ParticleValue value) {
    return mean_of(simulation, value, 0.3 * last.place, 0.7 * last.place);
  };
  auto const add = [&](char const* what, double measured, double reference, char const* unit) {
    results.push_back(compare(fmt::format("water-hugoniot: {} at {:g} m/s", what, u), measured,
                              reference, 0.03 * reference, unit, "exact: jump conditions"));
  };
  // The speed into water at rest.
  add("shock speed", speed_between(first, last) + u, exact.shock_speed, "m/s");
  add("pressure jump", behind(pressure_of) - p_0, exact.pressure - p_0, "Pa");
  add("density jump", behind(density_of) - rho, exact.density - rho, "kg/m^3");
}

}  // namespace

std::vector<CheckResult> check_water_hugoniot(Effort effort) {
  std::vector<CheckResult> results;
  double const spacing = effort == Effort::quick ? 4e-3 : 2e-3;
  for (double const u : {100.0, 300.0, 1000.0}) add_results(u, spacing, results);
  return results;
}

}  // namespace moraine
