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

/// What a run differs in (README.md).
struct Setting {
  FlowGeometry geometry;
  double smoothing_factor;
  DensityForm density;
  ContinuityForm continuity;
  double most = 4.0;  // bound of h, by that of the undisturbed gas
};

/// The energy that takes the shock to 1 m at the end.
SedovBlast blast_of(FlowGeometry geometry) {
  SedovBlast blast{geometry, 1.4, 1.0, 1.0};
  blast.energy = Sedov(blast).alpha();
  return blast;
}

/// Energy of the part of the blast that is computed: of the whole the model has a half, a quarter
/// or an eighth; in planar geometry that half counts as whole.
double part_of(SedovBlast const& blast, Model const& model) {
  return blast.energy / (blast.geometry == FlowGeometry::planar ? 1.0 : model.symmetry.copies());
}

/// Adds the energy of the blast to the gas near the origin, smoothly:
///
///   e ~ (1 - (r/R)^2)^2
///
/// The factor follows from the sum over the particles, so that the energy is exact.
void set_off(Model& model, SedovBlast const& blast, double radius) {
  ParticleStore& store = model.particles;
  std::vector<double> shape(store.range(Kind::fluid).size());
  double sum = 0.0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    double const q = distance_from_origin(store, i) / radius;
    shape[i] = q < 1.0 ? (1.0 - q * q) * (1.0 - q * q) : 0.0;
    sum += store.scalar(Field::mass)[i] * shape[i];
  }
  for (std::size_t i = 0; i < shape.size(); ++i)
    store.scalar(Field::specific_energy)[i] += part_of(blast, model) * shape[i] / sum;
}

Simulation explode(Setting const& setting, SedovBlast const& blast, double spacing,
                   double charge_radius) {
  Case c = shipped_case("noh");  // cold gas too
  std::get<IdealGas>(c.materials.front().eos).heat_capacity_ratio = blast.heat_capacity_ratio;
  c.time.end = 1.0;
  c.numerics.smoothing.most = setting.most;
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = setting.smoothing_factor;
  c.numerics.density = setting.density;
  c.numerics.continuity = setting.continuity;
  c.regions.front().initial.velocity = {};
  Model model = build_model(about_origin(c, setting.geometry, 1.2));
  set_off(model, blast, charge_radius);
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  return simulation;
}

/// What is read off at the end.
struct Exploded {
  double shock = 0.0;  // m, radius of half the pressure behind the shock
  double error = 0.0;  // L1, of the density out to 1.1 m
  double gain = 0.0;   // of energy, by that of the blast
};

Exploded read(Simulation const& simulation, Sedov const& exact, SedovBlast const& blast) {
  double const time = simulation.time();
  auto const compared = [&](double r) -> std::optional<FlowState> {
    if (r > 1.1) return std::nullopt;
    return exact.sample(r, time);
  };
  return {radius_of_pressure(simulation, 0.5 * exact.behind_shock(time).pressure, 0.02),
          l1_errors(simulation, FlowCoordinate::distance_from_origin, compared).density,
          simulation.sums().total_energy() / part_of(blast, simulation.model()) - 1.0};
}

struct Blast {
  char const* name;
  Setting setting;
  double charge_radius;             // spacings
  std::vector<double> full, quick;  // m, each finer than the one before
};

/// Density as a sum: radius, order, energy.
void add_blast(Blast const& of, Effort effort, std::vector<CheckResult>& results) {
  SedovBlast const blast = blast_of(of.setting.geometry);
  Sedov const exact(blast);
  std::vector<Exploded> at;
  auto const& spacings = effort == Effort::full ? of.full : of.quick;
  for (double const spacing : spacings)
    at.push_back(
        read(explode(of.setting, blast, spacing, of.charge_radius * spacing), exact, blast));
  std::string const name = fmt::format("sedov, {}", of.name);
  std::string const finest = fmt::format("at {:g} mm", 1e3 * spacings.back());
  results.push_back(compare(name + ": radius of the shock", at.back().shock, 1.0, 0.02, "m",
                            "of half the pressure, " + finest));
  for (std::size_t k = 1; k < at.size(); ++k)
    results.push_back(compare(
        fmt::format("{}: order, {:g} to {:g} mm", name, 1e3 * spacings[k - 1], 1e3 * spacings[k]),
        convergence_order(at[k - 1].error, at[k].error, spacings[k - 1] / spacings[k]), 0.8, 0.4,
        "-", fmt::format("L1 errors of density {:.3g}, {:.3g}", at[k - 1].error, at[k].error)));
  results.push_back(at_most(name + ": energy gained", at.back().gain, 1e-3, "-",
                            "by that of the blast, " + finest));
}

/// How density as a state fails.
struct Control {
  char const* name;
  FlowGeometry geometry;
  double coarse, fine;     // m
  Guard stops;             // the mass form
  std::string_view cause;  // words of its message
};

constexpr double charge_of_controls = 0.2;  // m

/// Whether all particles are flagged by the guard that is expected, and its message has the cause.
bool is_expected(SimulationError const& error, Control const& control) {
  auto const& flags = error.flags();
  return !flags.empty() && std::all_of(flags.begin(), flags.end(), [&](Flag const& flag) {
    return flag.guard == flag_of(control.stops);
  }) && std::string_view(error.what()).find(control.cause) != std::string_view::npos;
}

CheckResult stopped(Control const& control) {
  std::string const name = fmt::format("sedov, {}: mass form is stopped", control.name);
  Setting const setting{control.geometry, 1.3, DensityForm::continuity, ContinuityForm::mass};
  try {
    explode(setting, blast_of(control.geometry), control.coarse, charge_of_controls);
  } catch (SimulationError const& error) {
    std::string const words = error.what();
    return compare(name, is_expected(error, control) ? 1.0 : 0.0, 1.0, 0.0, "-",
                   words.substr(0, words.find(';')));
  }
  return compare(name, 0.0, 1.0, 0.0, "-", "no guard stops it");
}

CheckResult volume_form(Control const& control) {
  SedovBlast const blast = blast_of(control.geometry);
  Sedov const exact(blast);
  Setting const setting{control.geometry, 1.3, DensityForm::continuity, ContinuityForm::volume};
  auto const error = [&](double spacing) {
    return read(explode(setting, blast, spacing, charge_of_controls), exact, blast).error;
  };
  double const coarse = error(control.coarse), fine = error(control.fine);
  return below(fmt::format("sedov, {}: order, volume form: none", control.name),
               convergence_order(coarse, fine, control.coarse / control.fine), 0.25, "-",
               fmt::format("L1 errors of density {:.3g}, {:.3g}", coarse, fine));
}

}  // namespace

std::vector<CheckResult> check_sedov(Effort effort) {
  using enum FlowGeometry;
  constexpr auto sum = DensityForm::summation;
  constexpr auto mass = ContinuityForm::mass;
  std::vector<CheckResult> results;
  for (Blast const& blast :
       {Blast{"plane", {planar, 2.0, sum, mass, 16.0}, 10.0, {10e-3, 5e-3, 2.5e-3}, {10e-3, 5e-3}},
        Blast{
            "cylinder", {cylindrical, 1.6, sum, mass}, 10.0, {40e-3, 20e-3, 10e-3}, {40e-3, 20e-3}},
        Blast{"sphere", {spherical, 1.3, sum, mass}, 5.0, {80e-3, 60e-3, 40e-3}, {80e-3, 60e-3}}})
    add_blast(blast, effort, results);
  for (Control const& control :
       {Control{"cylinder", cylindrical, 40e-3, 20e-3, Guard::density, "its density"},
        Control{"sphere", spherical, 60e-3, 40e-3, Guard::state, "gives no sound speed"}}) {
    results.push_back(volume_form(control));
    results.push_back(stopped(control));
  }
  return results;
}

}  // namespace moraine
