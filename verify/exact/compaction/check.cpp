// Compaction waves: blocks of porous material that are thrown against a rigid wall.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <vector>

#include "exact/compaction.hpp"
#include "exact/isentrope.hpp"
#include "setup/build_model.hpp"
#include "setup/materials.hpp"
#include "verify/thrown_block.hpp"

namespace moraine {
namespace {

/// Weak porous rock: elastic up to 20 MPa, as stiff as 1200 m/s makes it.
constexpr PAlpha rock{.reference_density = 1900.0,
                      .reference_sound_speed = 1200.0,
                      .elastic_limit = 20e6,
                      .full_compaction_pressure = 400e6};

PAlpha sand() { return std::get<PAlpha>(shipped_material("dry_sand").spec.eos); }

struct Impact {
  char const* material;
  PAlpha law;
  double u;  // m/s

  CheckResult row(char const* what, double measured, double reference, char const* unit) const {
    return compare(fmt::format("compaction: {} of {} at {:g} m/s", what, material, u), measured,
                   reference, 0.03 * reference, unit, "exact: jump conditions");
  }
};

/// Where the two waves are when compaction has come to a place.
struct Waves {
  Passage main, precursor;
};

Waves run_to(Simulation& simulation, CompactionWaves const& waves, double place) {
  double const limit = waves.precursor ? waves.precursor->behind.pressure : 0.0;
  double const level = 0.5 * (limit + waves.main.behind.pressure);
  Passage const main = run_until(simulation, pressure_of, level, place);
  return {main, {main.time, crossing(simulation, pressure_of, 0.5 * limit)}};
}

/// Before 0.4 of the block is compacted, the release wave from its free end is not met yet.
void add_waves(Impact const& impact, double spacing, std::vector<CheckResult>& results) {
  auto const& [material, law, u] = impact;
  double const rho = law.reference_density;
  CompactionWaves const exact = waves_from_piston(law, rho, law.reference_energy, u);
  Simulation simulation(build_model(thrown_block({"porous", law}, u, spacing)));
  Waves const first = run_to(simulation, exact, 0.15 * block_length);
  Waves const last = run_to(simulation, exact, 0.4 * block_length);
  double const shock = last.main.place;
  auto const behind = [&](ParticleValue value) {
    return mean_of(simulation, value, 0.3 * shock, 0.7 * shock);
  };
  ShockState const& main = exact.main.behind;
  results.push_back(
      impact.row("speed", speed_between(first.main, last.main) + u, main.shock_speed, "m/s"));
  results.push_back(impact.row("pressure", behind(pressure_of), main.pressure, "Pa"));
  results.push_back(
      impact.row("density jump", behind(density_of) - rho, main.density - rho, "kg/m^3"));
  if (!exact.precursor) return;
  ShockState const& elastic = exact.precursor->behind;
  double const between = last.precursor.place - shock;
  results.push_back(impact.row("speed of the precursor",
                               speed_between(first.precursor, last.precursor) + u,
                               elastic.shock_speed, "m/s"));
  results.push_back(
      impact.row("pressure of the precursor",
                 mean_of(simulation, pressure_of, shock + 0.3 * between, shock + 0.7 * between),
                 elastic.pressure, "Pa"));
}

/// When all of the block is compacted and at rest, its free end springs back.
void add_rebound(Impact const& impact, double spacing, std::vector<CheckResult>& results) {
  auto const& [material, law, u] = impact;
  double const rho = law.reference_density;
  ShockState const at = waves_from_piston(law, rho, law.reference_energy, u).main.behind;
  Isentrope const release(law_of_loaded(law, at.density, at.specific_energy), at.density,
                          at.specific_energy);
  double const thickness = block_length * rho / at.density;
  double const compacted = block_length / at.shock_speed;  // when the wave has come to the free end
  Simulation simulation(build_model(thrown_block({"porous", law}, u, spacing)));
  double const end = compacted + 0.6 * thickness / release.start().sound_speed;
  while (simulation.time() < end) simulation.advance();
  results.push_back(impact.row("rebound",
                               mean_of(simulation, velocity_of, 0.7 * thickness, 0.9 * thickness),
                               release.end().velocity_change, "m/s"));
  results.back().note = "exact: release along the elastic line";
}

}  // namespace

std::vector<CheckResult> check_compaction(Effort effort) {
  std::vector<CheckResult> results;
  double const spacing = effort == Effort::quick ? 4e-3 : 2e-3;
  for (double const u : {50.0, 200.0, 600.0}) add_waves({"sand", sand(), u}, spacing, results);
  add_waves({"rock", rock, 100.0}, spacing, results);
  add_rebound({"sand", sand(), 200.0}, spacing, results);
  return results;
}

}  // namespace moraine
