// What must be true of a charge on soil.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "particle_order.hpp"
#include "plane_slab.hpp"
#include "probes/connected_body.hpp"
#include "probes/crater_probe.hpp"
#include "probes/point_probe.hpp"
#include "setup/build_model.hpp"
#include "setup/materials.hpp"
#include "step/simulation.hpp"
#include "verify/l1_errors.hpp"
#include "verify/shipped_cases.hpp"
#include "verify/thrown_block.hpp"

namespace moraine {
namespace {

constexpr double moment = 200e-6;  // s, at which craters are compared

Case charge(int cm, double spacing, Precision precision) {
  Case c = shipped_case(fmt::format("surface-charge-{}cm", cm));
  c.numerics.spacing = spacing;
  c.numerics.precision = precision;
  c.time.end = moment;
  return c;
}

double budget(Simulation const& simulation) {
  return energy_balance(simulation.sums(), simulation.lost(), simulation.booked());
}

CraterReading crater_of(Simulation const& simulation) {
  Numerics const& numerics = simulation.model().numerics;
  ParticleStore const& store = simulation.particles();
  ConnectedBody const body = connected_body(store, simulation.search(), numerics.smoothing_length(),
                                            Selection{{0}, {}}.of(store));
  BodyView const view{store,           simulation.search(),
                      numerics.kernel, numerics.smoothing_length(),
                      body.members,    Upwards{1, 1.0}};
  Model const& model = simulation.model();
  return probe_crater(view,
                      {0.0, {}, 0.45, 16, model.domain_min, model.domain_max, numerics.spacing});
}

double pressure_at(Simulation const& simulation, Vec3 const& place) {
  Numerics const& numerics = simulation.model().numerics;
  return probe_point(simulation.particles(), simulation.search(), numerics.kernel,
                     numerics.smoothing_length(), place)
      .pressure;
}

/// The same charge with a particle of TNT that starts 10 cm deep in the sand, where it blows itself
/// a bubble: the count must find it in the end.
CheckResult stray() {
  Case c = charge(6, 0.01, Precision::mixed);
  RegionSpec particle = c.regions.back();
  particle.name = "stray";
  particle.shape = Box{{0.0, -0.10, 0.0}, {0.01, -0.09, 0.0}};
  c.regions.push_back(particle);
  Simulation const simulation = run_to_end(c);
  return compare("surface-charge: penetration by a stray particle",
                 strangers(simulation.particles()), 1.0, 0.0, "particles",
                 "one of TNT that starts 10 cm deep in the sand, after 200 us");
}

/// What a gauge of the case below the charge has read.
struct GaugeCourse {
  std::string name;
  Vec3 place;                                       // m
  std::vector<std::pair<double, double>> readings;  // s, Pa

  double depth() const { return -place[1]; }
  double peak() const {
    double most = 0.0;
    for (auto const& [time, pressure] : readings) most = std::max(most, pressure);
    return most;
  }
  /// Of half of the peak [s].
  double arrival() const {
    double const half = 0.5 * peak();
    for (auto const& [time, pressure] : readings)
      if (pressure > half) return time;
    return std::numeric_limits<double>::quiet_NaN();
  }
};

std::vector<GaugeCourse> fixed_gauges(Case const& c) {
  std::vector<GaugeCourse> gauges;
  for (GaugeSpec const& gauge : c.gauges)
    if (gauge.kind == GaugeKind::point) gauges.push_back({gauge.name, gauge.position, {}});
  return gauges;
}

struct ChargeRun {
  CraterReading crater{};
  double energy = 0.0;  // error by the energy of the explosive
  std::vector<GaugeCourse> gauges;
  double early_asymmetry = 0.0, asymmetry = 0.0;
  int strangers = 0;

  /// Peak 25 cm below [Pa].
  double peak() const { return std::ranges::find(gauges, "C", &GaugeCourse::name)->peak(); }
};

ChargeRun run_charge(int cm, double spacing, Precision precision) {
  Case const c = charge(cm, spacing, precision);
  Simulation simulation(build_model(c));
  auto const mirror = mirror_images(simulation.particles());
  double const start = budget(simulation);
  ChargeRun run;
  run.gauges = fixed_gauges(c);
  while (simulation.running()) {
    simulation.advance();
    for (GaugeCourse& gauge : run.gauges)
      gauge.readings.emplace_back(simulation.time(), pressure_at(simulation, gauge.place));
    if (simulation.step() == 100) run.early_asymmetry = asymmetry(simulation, mirror);
  }
  Jwl const& tnt = std::get<Jwl>(simulation.model().materials[1].eos);
  double const explosive = cm * cm * 1e-4 * tnt.reference_density * tnt.reference_energy;  // J/m
  run.energy = std::fabs(budget(simulation) - start) / explosive;
  run.crater = crater_of(simulation);
  run.asymmetry = asymmetry(simulation, mirror);
  run.strangers = strangers(simulation.particles());
  return run;
}

/// Not sooner than the strongest possible shock, that of a plane slab, nor later than sound from
/// the ground.
CheckResult arrival(GaugeCourse const& gauge) {
  MaterialSpec const& sand = shipped_material("sand_loose").spec;
  double const sound =
      law_along_axis(sand).sound_speed(reference_density(sand.eos), reference_energy(sand.eos));
  double const soonest = 1e6 * gauge.depth() / slab_solution(sand).right_wave()->head;
  double const latest = 1e6 * gauge.depth() / sound;
  return compare(
      fmt::format("surface-charge: arrival at {}, {:g} cm below", gauge.name,
                  std::round(100.0 * gauge.depth())),
      1e6 * gauge.arrival(), 0.5 * (soonest + latest), 0.5 * (latest - soonest), "us",
      fmt::format("half of the peak of {:.4g} MPa; between the strongest possible shock and sound",
                  1e-6 * gauge.peak()));
}

void add_one_charge(ChargeRun const& run, std::vector<CheckResult>& results) {
  for (GaugeCourse const& gauge : run.gauges) results.push_back(arrival(gauge));
  results.push_back(at_most("surface-charge: energy", run.energy, 0.01, "-",
                            "change of the balance by the energy of the explosive"));
  results.push_back(at_most("surface-charge: symmetry over 100 steps", run.early_asymmetry, 1e-9,
                            "spacings", "double precision"));
  results.push_back(
      at_most("surface-charge: symmetry at the end", run.asymmetry, 1.0, "spacings", "200 us"));
  results.push_back(at_most("surface-charge: penetration", run.strangers, 0.0, "particles",
                            "alone among particles of the other material"));
}

/// A size that must grow from one run to the next.
CheckResult grows(char const* what, double smaller, double larger) {
  return compare(fmt::format("surface-charge: {} grows with the charge", what),
                 larger > smaller ? 1.0 : 0.0, 1.0, 0.0, "-",
                 fmt::format("{:.3g} and {:.3g} cm", 100.0 * smaller, 100.0 * larger));
}

CheckResult settles(char const* what, double coarse, double middle, double fine, double scale,
                    char const* unit) {
  return compare(fmt::format("surface-charge: {} by resolution", what), middle / fine, 1.0, 0.25,
                 "-",
                 fmt::format("{:.4g}, {:.4g}, {:.4g} {} at 2, 1, 0.5 cm", scale * coarse,
                             scale * middle, scale * fine, unit));
}

}  // namespace

std::vector<CheckResult> check_surface_charge(Effort effort) {
  std::vector<CheckResult> results;
  double const spacing = effort == Effort::quick ? 1e-3 : 0.5e-3;
  for (char const* soil : {"sand_loose", "sand_dense", "sand_saturated"})
    add_slab(soil, spacing, results);
  ChargeRun const six = run_charge(6, 0.01, Precision::full);
  add_one_charge(six, results);
  results.push_back(stray());
  if (effort == Effort::quick) return results;
  ChargeRun const four = run_charge(4, 0.01, Precision::mixed);
  ChargeRun const ten = run_charge(10, 0.01, Precision::mixed);
  results.push_back(
      grows("diameter (4, 6 cm)", four.crater.apparent_diameter, six.crater.apparent_diameter));
  results.push_back(
      grows("diameter (6, 10 cm)", six.crater.apparent_diameter, ten.crater.apparent_diameter));
  results.push_back(grows("depth (4, 6 cm)", four.crater.depth, six.crater.depth));
  results.push_back(grows("depth (6, 10 cm)", six.crater.depth, ten.crater.depth));
  ChargeRun const coarse = run_charge(6, 0.02, Precision::mixed);
  ChargeRun const fine = run_charge(6, 0.005, Precision::mixed);
  results.push_back(settles("diameter of the crater", coarse.crater.apparent_diameter,
                            six.crater.apparent_diameter, fine.crater.apparent_diameter, 100.0,
                            "cm"));
  results.push_back(settles("depth of the crater", coarse.crater.depth, six.crater.depth,
                            fine.crater.depth, 100.0, "cm"));
  results.push_back(
      settles("peak 25 cm below", coarse.peak(), six.peak(), fine.peak(), 1e-6, "MPa"));
  return results;
}

}  // namespace moraine
