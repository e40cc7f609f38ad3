// Plane shocks in solids: a block that is thrown against a rigid wall.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "exact/hugoniot.hpp"
#include "exact/uniaxial_solid.hpp"
#include "setup/build_model.hpp"
#include "setup/check_strength.hpp"
#include "setup/materials.hpp"
#include "verify/thrown_block.hpp"

namespace moraine {
namespace {

constexpr char const* page = "verify/exact/soil-shocks/README.md";
/// Regression bound: what swings behind the front add to the plastic work of unsaturated clay, 17.6
/// and 15.3 % of it.
constexpr double worst_of_pores = 0.2;

CheckResult within_3_percent(std::string const& name, double measured, double reference,
                             char const* unit) {
  return compare("soil-shocks: " + name, measured, reference, 0.03 * reference, unit,
                 "exact: jump conditions of the axial stress");
}

/// A block of a shipped material in front of the target.
struct Impact {
  MaterialSpec material;
  double u;  // m/s

  CheckResult row(char const* what, double measured, double reference, char const* unit) const {
    return within_3_percent(fmt::format("{} in {} at {:g} m/s", what, material.name, u), measured,
                            reference, unit);
  }
};

/// Plastic work [J/kg] of a solid with a yield strength Y of its own, compressed along one axis
/// from rho_0 to `density` without ever being let go: beyond the density rho_y at which it yields
/// the stress s_xx is 2/3 Y, the deviatoric strain all plastic and 2/3 of the whole,
///
///   w = 2/3 Y (1/rho_y - 1/rho),   rho_y = rho_0 exp(Y / (2 G)).
///
/// Every swing of the density behind the shock would add to it.
double plastic_work(VonMises const& law, double rho_0, double density) {
  double const yields = rho_0 * std::exp(0.5 * law.yield_strength / law.shear_modulus);
  return 2.0 / 3.0 * law.yield_strength * (1.0 / yields - 1.0 / density);
}

/// One shock carries all of the jump: what does not yield has no other, and in what yields it
/// overtakes the precursor at these speeds.
void add_solid(Impact const& impact, double spacing, std::vector<CheckResult>& results) {
  auto const& [material, u] = impact;
  Strength const strength = strength_of(material.strength);
  UniaxialSolid const solid{material.eos, strength};
  double const rho = reference_density(material.eos);
  double const e = reference_energy(material.eos);
  ShockState const exact = shock_from_piston(Law(solid), rho, e, u);
  double const ahead = solid.pressure(rho, e);
  Simulation simulation(build_model(thrown_block(material, u, spacing)));
  double const level = 0.5 * (ahead + exact.pressure);
  Passage const first = run_until(simulation, axial_stress, level, 0.15 * block_length);
  Passage const last = run_until(simulation, axial_stress, level, 0.4 * block_length);
  auto const behind = [&](ParticleValue value) {
    return mean_of(simulation, value, 0.3 * last.place, 0.7 * last.place);
  };
  results.push_back(
      impact.row("shock speed", speed_between(first, last) + u, exact.shock_speed, "m/s"));
  results.push_back(
      impact.row("stress jump", behind(axial_stress) - ahead, exact.pressure - ahead, "Pa"));
  results.push_back(
      impact.row("density jump", behind(density_of) - rho, exact.density - rho, "kg/m^3"));
  auto const* law = std::get_if<VonMises>(&strength);
  if (law == nullptr) return;
  results.push_back(impact.row("plastic work", behind(plastic_work_of),
                               plastic_work(*law, rho, exact.density), "J/kg"));
  results.back().note = "exact: compressed once, never let go";
  if (std::holds_alternative<PAlpha>(material.eos))
    results.back() = explained(results.back(), worst_of_pores * results.back().reference, page);
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
  Passage const first = run_until(simulation, axial_stress, 0.5 * limit, 0.3 * block_length);
  Passage const last = run_until(simulation, axial_stress, 0.5 * limit, 0.6 * block_length);
  results.push_back(within_3_percent("speed of the precursor in a metal",
                                     speed_between(first, last) + u,
                                     std::sqrt((bulk + 4.0 / 3.0 * shear) / rho), "m/s"));
  double const shock = crossing(simulation, axial_stress, 2.0 * limit);
  double const middle = 0.5 * (shock + last.place);
  double const part = 0.1 * (last.place - shock);
  results.push_back(within_3_percent(
      "stress behind the precursor",
      mean_of(simulation, axial_stress, middle - part, middle + part), limit, "Pa"));
}

}  // namespace

std::vector<CheckResult> check_soil_shocks(Effort effort) {
  std::vector<CheckResult> results;
  double const spacing = effort == Effort::quick ? 4e-3 : 2e-3;
  for (ShippedMaterial const& material : shipped_materials()) {
    if (material.spec.strength.kind == StrengthKind::none) continue;
    for (double const u : {100.0, 300.0}) add_solid({material.spec, u}, spacing, results);
  }
  add_precursor(2e-3, results);
  return results;
}

}  // namespace moraine
