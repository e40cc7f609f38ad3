// Noh's implosion in a plane, a cylinder and a sphere against its exact solution.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/noh.hpp"
#include "setup/build_model.hpp"
#include "verify/l1_errors.hpp"
#include "verify/radial_flow.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// What a geometry is run at, and how far the limits may be off (README.md).
struct Setting {
  FlowGeometry geometry;
  char const* name;
  double smoothing_factor;
  double tolerance;
  SpacingPair full, quick;
};

/// The gas reaches beyond what is compared, 1.5 shock radii, to where it is after the end.
Case implosion(Setting const& setting, Noh const& exact, double spacing) {
  Case c = shipped_case("noh");
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = setting.smoothing_factor;
  c.regions.front().initial.velocity = {};
  return about_origin(c, setting.geometry, c.time.end + 2.0 * exact.shock_position(c.time.end));
}

Simulation implode(Case const& c) {
  Model model = build_model(c);
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const r = distance_from_origin(store, i);
    for (int axis = 0; axis < store.dimension(); ++axis)
      store.component(Field::velocity, axis)[i] = -store.component(Field::position, axis)[i] / r;
  }
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  return simulation;
}

/// What is read off at the end.
struct Imploded {
  double density = 0.0;  // kg/m^3, mean from 0.4 to 0.8 of the radius of the exact shock
  double shock = 0.0;    // m/s, speed of half the pressure behind the shock
  double error = 0.0;    // L1, of the density out to 1.5 shock radii
};

Imploded read(Simulation const& simulation, Noh const& exact) {
  double const time = simulation.time();
  double const shock = exact.shock_position(time);
  double const half = 0.5 * exact.sample(0.0, time).pressure;
  auto const compared = [&](double r) -> std::optional<FlowState> {
    if (r > 1.5 * shock) return std::nullopt;
    return exact.sample(r, time);
  };
  return {mean_in_shell(simulation, Field::density, 0.4 * shock, 0.8 * shock),
          radius_of_pressure(simulation, half, 0.05 * shock) / time,
          l1_errors(simulation, FlowCoordinate::distance_from_origin, compared).density};
}

void add_geometry(Setting const& setting, Effort effort, std::vector<CheckResult>& results) {
  Noh const exact{setting.geometry};
  SpacingPair const at = effort == Effort::full ? setting.full : setting.quick;
  Imploded const coarse = read(implode(implosion(setting, exact, at.coarse)), exact);
  Imploded const fine = read(implode(implosion(setting, exact, at.fine)), exact);
  double const behind = exact.stagnation_density(), speed = exact.shock_position(1.0);
  std::string const name = fmt::format("noh, {}", setting.name);
  auto const limit = [&](char const* what, double first, double second, double reference,
                         char const* unit) {
    results.push_back(
        compare(fmt::format("{}: {}", name, what), first_order_limit(first, second, at.ratio()),
                reference, setting.tolerance * reference, unit,
                fmt::format("limit of {:.4g}, {:.4g} {}", first, second, in_words(at))));
  };
  limit("density behind the shock", coarse.density, fine.density, behind, "kg/m^3");
  limit("shock speed", coarse.shock, fine.shock, speed, "m/s");
  results.push_back(compare(
      name + ": order", convergence_order(coarse.error, fine.error, at.ratio()), 0.75, 0.35, "-",
      fmt::format("L1 errors of density {:.3g}, {:.3g} {}", coarse.error, fine.error,
                  in_words(at))));
}

}  // namespace

std::vector<CheckResult> check_noh(Effort effort) {
  std::vector<CheckResult> results;
  for (Setting const& setting :
       {Setting{FlowGeometry::planar, "plane", 2.0, 0.05, {10e-3, 5e-3}, {10e-3, 5e-3}},
        Setting{FlowGeometry::cylindrical, "cylinder", 1.3, 0.05, {20e-3, 10e-3}, {40e-3, 20e-3}},
        Setting{FlowGeometry::spherical, "sphere", 1.3, 0.1, {60e-3, 30e-3}, {60e-3, 40e-3}}})
    add_geometry(setting, effort, results);
  return results;
}

}  // namespace moraine
