// Compaction waves: blocks of porous material that are thrown against a rigid wall.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "exact/compaction.hpp"
#include "exact/isentrope.hpp"
#include "setup/build_model.hpp"
#include "setup/materials.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double length = 1.0;  // m, of the block

/// Weak porous rock: elastic up to 20 MPa, as stiff as 1200 m/s makes it.
constexpr PAlpha rock{.reference_density = 1900.0,
                      .reference_sound_speed = 1200.0,
                      .elastic_limit = 20e6,
                      .full_compaction_pressure = 400e6};

PAlpha sand() { return std::get<PAlpha>(shipped_material("dry_sand").spec.eos); }

/// One metre of `law` with velocity -u in front of a wall at x = 0.
Case thrown_block(PAlpha const& law, double u, double spacing) {
  Case c;
  c.dimension = 1;
  c.domain = {{-length, 0.0, 0.0}, {2.0 * length, 0.0, 0.0}};
  c.numerics.spacing = spacing;
  c.numerics.precision = Precision::full;
  c.time.end = 1.0;  // never reached
  c.materials = {{"porous", law}};
  RegionSpec block{"block", "porous", Box{{0.0, 0.0, 0.0}, {length, 0.0, 0.0}}, {}};
  block.initial.velocity = {-u, 0.0, 0.0};
  c.regions = {block};
  WallSpec wall;
  wall.name = "target";
  wall.box = {{0.0, 0.0, 0.0}, {2.0 * length, 0.0, 0.0}};
  wall.open[0][1] = true;
  c.walls = {wall};
  return c;
}

/// Farthest place where the pressure crosses `level`; 0 if it does nowhere.
double crossing(Simulation const& simulation, double level) {
  ParticleStore const& store = simulation.particles();
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    points.emplace_back(store.component(Field::position, 0)[i], store.scalar(Field::pressure)[i]);
  std::sort(points.begin(), points.end());
  for (std::size_t k = points.size() - 1; k > 0; --k) {
    auto const [x, p] = points[k - 1];
    auto const [x_next, p_next] = points[k];
    if (p >= level && p_next < level) return x + (x_next - x) * (p - level) / (p - p_next);
  }
  return 0.0;
}

double mean(Simulation const& simulation, std::span<double const> values, double from, double to) {
  ParticleStore const& store = simulation.particles();
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    if (x < from || x > to) continue;
    sum += values[i];
    count += 1.0;
  }
  return sum / count;
}

struct Impact {
  char const* material;
  PAlpha law;
  double u;  // m/s

  CheckResult row(char const* what, double measured, double reference, char const* unit) const {
    return compare(fmt::format("compaction: {} of {} at {:g} m/s", what, material, u), measured,
                   reference, 0.03 * reference, unit, "exact: jump conditions");
  }
};

/// Places of the two waves when compaction has come to `reach`, and when that was.
struct Passage {
  double time, main, precursor;
};

Passage run_to(Simulation& simulation, CompactionWaves const& waves, double reach) {
  double const limit = waves.precursor ? waves.precursor->behind.pressure : 0.0;
  double const level = 0.5 * (limit + waves.main.behind.pressure);
  while (simulation.running() && crossing(simulation, level) < reach) simulation.advance();
  return {simulation.time(), crossing(simulation, level), crossing(simulation, 0.5 * limit)};
}

/// Before 0.4 of the block is compacted, the release wave from its free end is not met yet.
void add_waves(Impact const& impact, double spacing, std::vector<CheckResult>& results) {
  auto const& [material, law, u] = impact;
  double const rho = law.reference_density;
  CompactionWaves const exact = waves_from_piston(law, rho, law.reference_energy, u);
  Simulation simulation(build_model(thrown_block(law, u, spacing)));
  Passage const first = run_to(simulation, exact, 0.15 * length);
  Passage const last = run_to(simulation, exact, 0.4 * length);
  double const time = last.time - first.time;
  ParticleStore const& store = simulation.particles();
  auto const behind = [&](Field field) {
    return mean(simulation, store.scalar(field), 0.3 * last.main, 0.7 * last.main);
  };
  ShockState const& main = exact.main.behind;
  results.push_back(
      impact.row("speed", (last.main - first.main) / time + u, main.shock_speed, "m/s"));
  results.push_back(impact.row("pressure", behind(Field::pressure), main.pressure, "Pa"));
  results.push_back(
      impact.row("density jump", behind(Field::density) - rho, main.density - rho, "kg/m^3"));
  if (!exact.precursor) return;
  ShockState const& elastic = exact.precursor->behind;
  double const between = last.precursor - last.main;
  results.push_back(impact.row("speed of the precursor",
                               (last.precursor - first.precursor) / time + u, elastic.shock_speed,
                               "m/s"));
  results.push_back(impact.row("pressure of the precursor",
                               mean(simulation, store.scalar(Field::pressure),
                                    last.main + 0.3 * between, last.main + 0.7 * between),
                               elastic.pressure, "Pa"));
}

/// When all of the block is compacted and at rest, its free end springs back.
void add_rebound(Impact const& impact, double spacing, std::vector<CheckResult>& results) {
  auto const& [material, law, u] = impact;
  double const rho = law.reference_density;
  ShockState const at = waves_from_piston(law, rho, law.reference_energy, u).main.behind;
  Isentrope const release(law_of_loaded(law, at.density, at.specific_energy), at.density,
                          at.specific_energy);
  double const thickness = length * rho / at.density;
  double const compacted = length / at.shock_speed;  // when the wave has come to the free end
  Simulation simulation(build_model(thrown_block(law, u, spacing)));
  double const end = compacted + 0.6 * thickness / release.start().sound_speed;
  while (simulation.time() < end) simulation.advance();
  results.push_back(
      impact.row("rebound",
                 mean(simulation, simulation.particles().component(Field::velocity, 0),
                      0.7 * thickness, 0.9 * thickness),
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
