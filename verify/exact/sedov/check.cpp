// Sedov's blast wave in a plane, a cylinder and a sphere against its exact solution.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "exact/sedov.hpp"
#include "setup/build_model.hpp"
#include "step/guard.hpp"
#include "step/simulation_error.hpp"
#include "verify/l1_errors.hpp"
#include "verify/radial_flow.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// What a geometry is run at (README.md).
struct Setting {
  FlowGeometry geometry;
  char const* name;
  double smoothing_factor;
  ContinuityForm continuity;
  double charge_radius;  // m
  SpacingPair full, quick;
  Guard stops = Guard::finite;  // the mass form, where it does not hold
  std::string_view cause{};     // words of its message
};

/// The energy that takes the shock to 1 m at the end.
SedovBlast blast_of(FlowGeometry geometry) {
  SedovBlast blast{geometry, 1.4, 1.0, 1.0};
  blast.energy = Sedov(blast).alpha();
  return blast;
}

/// Adds the energy of the blast to the gas near the origin, smoothly:
///
///   e ~ (1 - (r/R)^2)^2
///
/// The factor follows from the sum over the particles, so that the energy is exact. Of the whole
/// the model has a half, a quarter or an eighth; in planar geometry that half counts as whole.
void set_off(Model& model, SedovBlast const& blast, double radius) {
  ParticleStore& store = model.particles;
  std::vector<double> shape(store.range(Kind::fluid).size());
  double sum = 0.0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    double const q = distance_from_origin(store, i) / radius;
    shape[i] = q < 1.0 ? (1.0 - q * q) * (1.0 - q * q) : 0.0;
    sum += store.scalar(Field::mass)[i] * shape[i];
  }
  double const parts = blast.geometry == FlowGeometry::planar ? 1.0 : model.symmetry.copies();
  for (std::size_t i = 0; i < shape.size(); ++i)
    store.scalar(Field::specific_energy)[i] += blast.energy / parts * shape[i] / sum;
}

Simulation explode(Setting const& setting, SedovBlast const& blast, double spacing) {
  Case c = shipped_case("noh");  // cold gas too
  std::get<IdealGas>(c.materials.front().eos).heat_capacity_ratio = blast.heat_capacity_ratio;
  c.time.end = 1.0;
  c.numerics.smoothing.most = 4.0;
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = setting.smoothing_factor;
  c.numerics.continuity = setting.continuity;
  c.regions.front().initial.velocity = {};
  Model model = build_model(about_origin(c, setting.geometry, 1.2));
  set_off(model, blast, setting.charge_radius);
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  return simulation;
}

/// What is read off at the end.
struct Exploded {
  double shock = 0.0;  // m, radius of half the pressure behind the shock
  double peak = 0.0;   // kg/m^3, largest density
  double error = 0.0;  // L1, of the density out to 1.1 m
};

Exploded read(Simulation const& simulation, Sedov const& exact) {
  double const time = simulation.time();
  auto const compared = [&](double r) -> std::optional<FlowState> {
    if (r > 1.1) return std::nullopt;
    return exact.sample(r, time);
  };
  auto const density = simulation.particles().scalar(Field::density);
  return {radius_of_pressure(simulation, 0.5 * exact.behind_shock(time).pressure, 0.02),
          *std::max_element(density.begin(), density.end()),
          l1_errors(simulation, FlowCoordinate::distance_from_origin, compared).density};
}

/// Whether all particles are flagged by the guard that is expected, and its message has the cause.
bool is_expected(SimulationError const& error, Setting const& setting) {
  auto const& flags = error.flags();
  return !flags.empty() && std::all_of(flags.begin(), flags.end(), [&](Flag const& flag) {
    return flag.guard == flag_of(setting.stops);
  }) && std::string_view(error.what()).find(setting.cause) != std::string_view::npos;
}

/// Passes when the guard of the setting stops the run for its cause (README.md).
CheckResult stopped(Setting setting, double spacing) {
  setting.continuity = ContinuityForm::mass;
  std::string const name = fmt::format("sedov, {}: mass form is stopped", setting.name);
  try {
    explode(setting, blast_of(setting.geometry), spacing);
  } catch (SimulationError const& error) {
    std::string const words = error.what();
    return compare(name, is_expected(error, setting) ? 1.0 : 0.0, 1.0, 0.0, "-",
                   words.substr(0, words.find(';')));
  }
  return compare(name, 0.0, 1.0, 0.0, "-", "no guard stops it");
}

void add_geometry(Setting const& setting, Effort effort, std::vector<CheckResult>& results) {
  SedovBlast const blast = blast_of(setting.geometry);
  Sedov const exact(blast);
  SpacingPair const at = effort == Effort::full ? setting.full : setting.quick;
  Exploded const coarse = read(explode(setting, blast, at.coarse), exact);
  Exploded const fine = read(explode(setting, blast, at.fine), exact);
  double const radius = exact.shock_position(1.0), behind = exact.behind_shock(1.0).density;
  std::string const name = fmt::format("sedov, {}", setting.name);
  results.push_back(at_most(
      name + ": what the shock's radius lacks", (radius - fine.shock) / (radius - coarse.shock),
      0.95, "-",
      fmt::format("{:.4f}, {:.4f} of {:g} m {}", coarse.shock, fine.shock, radius, in_words(at))));
  if (setting.continuity == ContinuityForm::volume) {
    results.push_back(
        at_most(name + ": order, volume form: none",
                std::max(0.0, convergence_order(coarse.error, fine.error, at.ratio())), 0.25, "-",
                fmt::format("L1 errors of density {:.3g}, {:.3g}", coarse.error, fine.error)));
    results.push_back(stopped(setting, at.coarse));
    return;
  }
  results.push_back(compare(name + ": radius of the shock", fine.shock, radius, 0.05 * radius, "m",
                            fmt::format("half the pressure, {:g} mm", 1e3 * at.fine)));
  results.push_back(at_most(name + ": what the peak lacks",
                            (behind - fine.peak) / (behind - coarse.peak), 0.95, "-",
                            fmt::format("densities {:.3f}, {:.3f} of {:g} {}", coarse.peak,
                                        fine.peak, behind, in_words(at))));
}

}  // namespace

std::vector<CheckResult> check_sedov(Effort effort) {
  using enum ContinuityForm;
  std::vector<CheckResult> results;
  for (Setting const& setting :
       {Setting{FlowGeometry::planar, "plane", 2.0, mass, 0.1, {10e-3, 5e-3}, {10e-3, 5e-3}},
        Setting{FlowGeometry::cylindrical,
                "cylinder",
                1.3,
                volume,
                0.2,
                {40e-3, 20e-3},
                {40e-3, 20e-3}},
        Setting{
            FlowGeometry::spherical, "sphere", 1.3, volume, 0.2, {60e-3, 40e-3}, {60e-3, 40e-3}}})
    add_geometry(setting, effort, results);
  return results;
}

}  // namespace moraine
