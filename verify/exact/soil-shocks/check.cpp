// Plane shocks in solids: a block that is thrown against a rigid wall.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "exact/hugoniot.hpp"
#include "exact/uniaxial_solid.hpp"
#include "setup/build_model.hpp"
#include "setup/check_strength.hpp"
#include "setup/materials.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr double length = 1.0;  // m, of the block

/// One metre of a solid with velocity -u in front of a wall at x = 0.
Case thrown_block(MaterialSpec const& material, double u, double spacing) {
  Case c;
  c.dimension = 1;
  c.domain = {{-length, 0.0, 0.0}, {2.0 * length, 0.0, 0.0}};
  c.numerics.spacing = spacing;
  c.numerics.precision = Precision::full;
  c.time.end = 1.0;  // never reached
  c.materials = {material};
  RegionSpec block{"block", material.name, Box{{0.0, 0.0, 0.0}, {length, 0.0, 0.0}}, {}};
  block.initial.velocity = {-u, 0.0, 0.0};
  c.regions = {block};
  WallSpec wall;
  wall.name = "target";
  wall.box = {{0.0, 0.0, 0.0}, {2.0 * length, 0.0, 0.0}};
  wall.open[0][1] = true;
  c.walls = {wall};
  return c;
}

/// -sigma_xx of a particle.
double axial_stress(ParticleStore const& store, std::size_t i) {
  return store.scalar(Field::pressure)[i] - store.component(Field::deviatoric_stress, 0)[i];
}

/// Farthest place where the axial stress crosses `level`; 0 if it does nowhere.
double crossing(Simulation const& simulation, double level) {
  ParticleStore const& store = simulation.particles();
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    points.emplace_back(store.component(Field::position, 0)[i], axial_stress(store, i));
  std::sort(points.begin(), points.end());
  for (std::size_t k = points.size() - 1; k > 0; --k) {
    auto const [x, stress] = points[k - 1];
    auto const [x_next, stress_next] = points[k];
    if (stress >= level && stress_next < level)
      return x + (x_next - x) * (stress - level) / (stress - stress_next);
  }
  return 0.0;
}

struct Means {
  double stress = 0.0, density = 0.0;
};

Means means_between(Simulation const& simulation, double from, double to) {
  ParticleStore const& store = simulation.particles();
  Means sum;
  double count = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    if (x < from || x > to) continue;
    sum.stress += axial_stress(store, i);
    sum.density += store.scalar(Field::density)[i];
    count += 1.0;
  }
  return {sum.stress / count, sum.density / count};
}

CheckResult within_3_percent(std::string const& name, double measured, double reference,
                             char const* unit) {
  return compare("soil-shocks: " + name, measured, reference, 0.03 * reference, unit,
                 "exact: jump conditions of the axial stress");
}

/// Runs until the stress crosses `level` at `place`; time and place of the crossing.
std::pair<double, double> run_to(Simulation& simulation, double level, double place) {
  while (simulation.running() && crossing(simulation, level) < place) simulation.advance();
  return {simulation.time(), crossing(simulation, level)};
}

void add_soil(std::string const& soil, double u, double spacing,
              std::vector<CheckResult>& results) {
  MaterialSpec const& material = shipped_material(soil).spec;
  UniaxialSolid const solid{material.eos, strength_of(material.strength)};
  double const rho = reference_density(material.eos);
  double const e = reference_energy(material.eos);
  ShockState const exact = shock_from_piston(Law(solid), rho, e, u);
  double const ahead = solid.pressure(rho, e);
  Simulation simulation(build_model(thrown_block(material, u, spacing)));
  double const level = 0.5 * (ahead + exact.pressure);
  auto const [t_1, x_1] = run_to(simulation, level, 0.15 * length);
  auto const [t_2, x_2] = run_to(simulation, level, 0.4 * length);
  Means const behind = means_between(simulation, 0.3 * x_2, 0.7 * x_2);
  auto const name = [&](char const* what) {
    return fmt::format("{} in {} at {:g} m/s", what, soil, u);
  };
  results.push_back(within_3_percent(name("shock speed"), (x_2 - x_1) / (t_2 - t_1) + u,
                                     exact.shock_speed, "m/s"));
  results.push_back(
      within_3_percent(name("stress jump"), behind.stress - ahead, exact.pressure - ahead, "Pa"));
  results.push_back(
      within_3_percent(name("density jump"), behind.density - rho, exact.density - rho, "kg/m^3"));
}

MaterialSpec aluminium() {
  MieGrueneisen pressure;
  pressure.reference_density = 2785.0;
  pressure.reference_sound_speed = 5328.0;
  pressure.hugoniot_slope = 1.338;
  pressure.grueneisen_coefficient = 2.0;
  pressure.least_pressure = -1e9;
  MaterialSpec metal{.name = "aluminium", .eos = pressure};
  metal.strength = {
      .kind = StrengthKind::von_mises, .shear_modulus = 27.6e9, .yield_strength = 0.3e9};
  return metal;
}

/// The precursor runs away from the shock that follows it; at 4 mm the two are not apart yet.
void add_precursor(double spacing, std::vector<CheckResult>& results) {
  MaterialSpec const metal = aluminium();
  double const u = 200.0;
  double const rho = reference_density(metal.eos);
  double const bulk = std::get<MieGrueneisen>(metal.eos).stiffness();
  double const shear = *metal.strength.shear_modulus;
  double const limit = *metal.strength.yield_strength * (0.5 * bulk / shear + 2.0 / 3.0);
  Simulation simulation(build_model(thrown_block(metal, u, spacing)));
  auto const [t_1, x_1] = run_to(simulation, 0.5 * limit, 0.3 * length);
  auto const [t_2, x_2] = run_to(simulation, 0.5 * limit, 0.6 * length);
  results.push_back(within_3_percent("speed of the precursor in a metal",
                                     (x_2 - x_1) / (t_2 - t_1) + u,
                                     std::sqrt((bulk + 4.0 / 3.0 * shear) / rho), "m/s"));
  double const shock = crossing(simulation, 2.0 * limit);
  double const middle = 0.5 * (shock + x_2);
  double const part = 0.1 * (x_2 - shock);
  results.push_back(within_3_percent("stress behind the precursor",
                                     means_between(simulation, middle - part, middle + part).stress,
                                     limit, "Pa"));
}

}  // namespace

std::vector<CheckResult> check_soil_shocks(Effort effort) {
  std::vector<CheckResult> results;
  double const spacing = effort == Effort::quick ? 4e-3 : 2e-3;
  for (char const* soil : {"sand_loose", "sand_dense", "sand_saturated"})
    for (double const u : {100.0, 300.0}) add_soil(soil, u, spacing, results);
  add_precursor(2e-3, results);
  return results;
}

}  // namespace moraine
