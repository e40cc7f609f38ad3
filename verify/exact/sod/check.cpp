// Sod's shock tube against the exact solution of the Riemann problem.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "exact/riemann_ideal_gas.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// Sum of volume |f - exact| over all particles, divided by the sum of volume |exact|.
struct Errors {
  double density = 0.0;
  double velocity = 0.0;
  double pressure = 0.0;
};

Errors errors_of(Simulation const& simulation, RiemannIdealGas const& exact) {
  ParticleStore const& store = simulation.particles();
  auto const x = store.component(Field::position, 0);
  auto const v = store.component(Field::velocity, 0);
  auto const rho = store.scalar(Field::density);
  auto const p = store.scalar(Field::pressure);
  auto const mass = store.scalar(Field::mass);
  Errors error, size;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    FlowState const sample = exact.sample(x[i] / simulation.time());
    double const volume = mass[i] / rho[i];
    error.density += volume * std::fabs(rho[i] - sample.density);
    error.velocity += volume * std::fabs(v[i] - sample.velocity);
    error.pressure += volume * std::fabs(p[i] - sample.pressure);
    size.density += volume * sample.density;
    size.velocity += volume * sample.velocity;
    size.pressure += volume * sample.pressure;
  }
  return {error.density / size.density, error.velocity / size.velocity,
          error.pressure / size.pressure};
}

}  // namespace

std::vector<CheckResult> check_sod(Effort effort) {
  Case tube = shipped_case("sod");
  RiemannIdealGas const exact({1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, 1.4);
  // At four millimetres the smeared shock and contact would overlap (README.md).
  std::vector<double> spacings{2e-3, 1e-3};
  if (effort == Effort::full) spacings.push_back(0.5e-3);
  std::vector<Errors> errors;
  for (double const spacing : spacings) {
    tube.numerics.spacing = spacing;
    Simulation simulation(build_model(tube));
    while (simulation.running()) simulation.advance();
    errors.push_back(errors_of(simulation, exact));
  }
  std::string const at = fmt::format("L1, {:g} mm, t = 0.2 s", 1e3 * spacings.back());
  std::vector<CheckResult> results{at_most("sod: density", errors.back().density, 0.03, "-", at),
                                   at_most("sod: velocity", errors.back().velocity, 0.03, "-", at),
                                   at_most("sod: pressure", errors.back().pressure, 0.03, "-", at)};
  for (std::size_t k = 1; k < errors.size(); ++k)
    results.push_back(compare(
        fmt::format("sod: order, {:g} to {:g} mm", 1e3 * spacings[k - 1], 1e3 * spacings[k]),
        std::log2(errors[k - 1].density / errors[k].density), 0.9, 0.2, "-",
        fmt::format("density errors {:.3g}, {:.3g}", errors[k - 1].density, errors[k].density)));
  return results;
}

}  // namespace moraine
