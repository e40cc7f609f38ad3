// Sod's shock tube against the exact solution of the Riemann problem.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
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
    GasSample const sample = exact.sample(x[i] / simulation.time());
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

std::vector<CheckResult> check_sod(Effort) {
  Case tube = shipped_case("sod");
  RiemannIdealGas const exact({1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, 1.4);
  std::array<Errors, 3> errors;
  double const finest = tube.numerics.spacing;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    tube.numerics.spacing = finest * std::pow(2.0, 2.0 - static_cast<double>(k));
    Simulation simulation(build_model(tube));
    while (simulation.running()) simulation.advance();
    errors[k] = errors_of(simulation, exact);
  }
  Errors const& last = errors[2];
  // A scheme that smears shocks over a fixed number of spacings has L1 errors of first order there
  // and between 1/2 and 1 at the contact (Banks, Aslam & Rider, J. Comput. Phys. 227 (2008) 6985).
  double const order = 0.5 * std::log2(errors[0].density / last.density);
  std::string const at = fmt::format("L1, {:.0f} mm, t = 0.2 s", 1e3 * finest);
  return {at_most("sod: density", last.density, 0.03, "-", at),
          at_most("sod: velocity", last.velocity, 0.03, "-", at),
          at_most("sod: pressure", last.pressure, 0.03, "-", at),
          compare("sod: order", order, 0.9, 0.2, "-",
                  fmt::format("density errors {:.3g}, {:.3g}, {:.3g}", errors[0].density,
                              errors[1].density, last.density))};
}

}  // namespace moraine
