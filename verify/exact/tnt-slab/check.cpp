// A slab of TNT: detonation from a rigid wall with programmed burn, and release of a slab that has
// burnt in an instant, against exact solutions.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "exact/detonation.hpp"
#include "exact/slab_release.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/l1_errors.hpp"
#include "verify/profile.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

constexpr double thickness = 0.1;  // m

struct Detonated {
  double speed = 0.0;  // m/s, of the front on its way from 3 to 9 cm
  double rest = 0.0;   // Pa, mean of the inner nine tenths of the zone at rest
  double peak = 0.0;   // Pa
  double drift = 0.0;  // of the total energy, over that of the explosive
  L1Errors errors;
};

Detonated detonate(Case slab, double spacing, TaylorWave const& exact) {
  slab.numerics.spacing = spacing;
  Simulation simulation(build_model(slab));
  double const energy = simulation.sums().total_energy();
  double const half = 0.5 * exact.detonation().behind.pressure;
  double near_time = 0.0, near = 0.0, far_time = 0.0, far = 0.0;
  while (simulation.running()) {
    simulation.advance();
    double const at = front_of_pressure(simulation, half);
    if (at < 0.03) near_time = simulation.time(), near = at;
    if (at < 0.09) far_time = simulation.time(), far = at;
  }
  double const time = simulation.time();
  auto const p = simulation.particles().scalar(Field::pressure);
  return {
      (far - near) / (far_time - near_time),
      mean_between(simulation, Field::pressure, 0.0, 0.9 * exact.rest_speed() * time),
      *std::max_element(p.begin(), p.end()),
      std::fabs(simulation.sums().total_energy() - energy) / energy,
      l1_errors(simulation, FlowCoordinate::x, [&](double x) { return exact.sample(x / time); })};
}

std::vector<CheckResult> programmed(Case const& slab, TaylorWave const& exact,
                                    std::vector<double> const& spacings) {
  std::vector<Detonated> runs;
  for (double const spacing : spacings) runs.push_back(detonate(slab, spacing, exact));
  Detonated const& finest = runs.back();
  Detonation const& cj = exact.detonation();
  double const peak = cj.behind.pressure;
  std::string const at =
      fmt::format("{:g} mm, t = {:g} us", 1e3 * spacings.back(), 1e6 * slab.time.end);
  std::vector<CheckResult> results{
      compare("tnt-slab: speed of the front", finest.speed, cj.speed, 0.01 * cj.speed, "m/s",
              "half the C-J pressure, from 3 to 9 cm; " + at),
      compare("tnt-slab: pressure at rest", 1e-9 * finest.rest, 1e-9 * exact.rest().pressure,
              0.03e-9 * exact.rest().pressure, "GPa",
              "between the wall and the Taylor wave; " + at),
      at_most("tnt-slab: density", finest.errors.density, 0.02, "-", "L1; " + at),
      compare("tnt-slab: peak", 1e-9 * finest.peak, 1e-9 * peak, 0.1e-9 * peak, "GPa",
              "C-J pressure, the edge of a cusp; " + at),
      at_most("tnt-slab: energy", finest.drift, 0.01, "-",
              "change of the total / energy of the explosive; " + at)};
  for (std::size_t k = 1; k < runs.size(); ++k)
    results.push_back(at_most(
        fmt::format("tnt-slab: peak, {:g} to {:g} mm", 1e3 * spacings[k - 1], 1e3 * spacings[k]),
        (peak - runs[k].peak) / (peak - runs[k - 1].peak), 0.9, "-",
        fmt::format("what {:.2f} GPa lacks of C-J, by what {:.2f} GPa lacks", 1e-9 * runs[k].peak,
                    1e-9 * runs[k - 1].peak)));
  return results;
}

std::vector<CheckResult> instantaneous(Case slab, Jwl const& tnt, double spacing) {
  slab.materials.front().burn.kind = BurnKind::instantaneous;
  slab.numerics.spacing = spacing;
  SlabRelease const exact(RiemannSide{tnt, tnt.reference_density, 0.0, tnt.reference_energy},
                          std::nullopt, thickness);
  Simulation const simulation = run_to_end(slab);
  L1Errors const errors = l1_errors(simulation, FlowCoordinate::x,
                                    [&](double x) { return exact.sample(x, simulation.time()); });
  std::string const at =
      fmt::format("L1, {:g} mm, t = {:g} us", 1e3 * spacing, 1e6 * simulation.time());
  return {at_most("tnt-slab: release, density", errors.density, 0.03, "-", at),
          at_most("tnt-slab: release, pressure", errors.pressure, 0.03, "-", at),
          at_most("tnt-slab: release, velocity", errors.velocity, 0.03, "-",
                  at + ", weighted with masses")};
}

}  // namespace

std::vector<CheckResult> check_tnt_slab(Effort effort) {
  Case const slab = shipped_case("tnt-slab");
  Jwl const tnt = std::get<Jwl>(slab.materials.front().eos);
  TaylorWave const exact(Explosive{tnt, tnt.reference_density, tnt.reference_energy});
  std::vector<double> spacings{0.2e-3, 0.1e-3, 0.05e-3};
  if (effort == Effort::full) spacings.push_back(0.025e-3);
  auto results = programmed(slab, exact, spacings);
  for (CheckResult& result : instantaneous(slab, tnt, 0.1e-3)) results.push_back(std::move(result));
  return results;
}

}  // namespace moraine
