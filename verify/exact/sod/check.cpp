// Sod's shock tube against the exact solution of the Riemann problem.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <string>
#include <vector>

#include "exact/riemann_ideal_gas.hpp"
#include "verify/l1_errors.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// Errors at the end of the run at each spacing [m].
std::vector<L1Errors> errors_at(std::vector<double> const& spacings, Case tube) {
  RiemannIdealGas const exact({1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, 1.4);
  std::vector<L1Errors> errors;
  for (double const spacing : spacings) {
    tube.numerics.spacing = spacing;
    Simulation const simulation = run_to_end(tube);
    errors.push_back(l1_errors(simulation, FlowCoordinate::x,
                               [&](double x) { return exact.sample(x / simulation.time()); }));
  }
  return errors;
}

double order(std::vector<L1Errors> const& errors, std::size_t k) {
  return convergence_order(errors[k - 1].density, errors[k].density);
}

/// Smoothing lengths of two spacings, which the expanding gas outgrows unless they follow it.
void add_two_spacings(std::vector<double> const& spacings, std::vector<CheckResult>& results) {
  Case tube = shipped_case("sod");
  tube.numerics.smoothing_factor = 2.0;
  auto const constant = errors_at(spacings, tube);
  tube.numerics.smoothing.mode = SmoothingMode::density;
  tube.numerics.smoothing.most = 4.0;
  auto const variable = errors_at(spacings, tube);
  std::size_t const last = spacings.size() - 1;
  auto const two = [&](std::vector<L1Errors> const& errors) {
    return fmt::format("density errors {:.3g}, {:.3g} at {:g} and {:g} mm",
                       errors[last - 1].density, errors[last].density, 1e3 * spacings[last - 1],
                       1e3 * spacings[last]);
  };
  results.push_back(at_most("sod: density, h of 2 spacings by density", variable[last].density,
                            0.01, "-", two(variable)));
  results.push_back(compare("sod: order, h of 2 spacings by density", order(variable, last), 0.75,
                            0.25, "-", two(variable)));
  results.push_back(below("sod: order, constant h of 2 spacings: none", order(constant, last), 0.25,
                          "-", two(constant)));
}

}  // namespace

std::vector<CheckResult> check_sod(Effort effort) {
  Case const tube = shipped_case("sod");
  // At four millimetres the smeared shock and contact would overlap (README.md).
  std::vector<double> spacings{2e-3, 1e-3};
  if (effort == Effort::full) spacings.push_back(0.5e-3);
  std::vector<L1Errors> const errors = errors_at(spacings, tube);
  std::string const at = fmt::format("L1, {:g} mm, t = 0.2 s", 1e3 * spacings.back());
  std::vector<CheckResult> results{at_most("sod: density", errors.back().density, 0.03, "-", at),
                                   at_most("sod: velocity", errors.back().velocity, 0.03, "-", at),
                                   at_most("sod: pressure", errors.back().pressure, 0.03, "-", at)};
  for (std::size_t k = 1; k < errors.size(); ++k)
    results.push_back(compare(
        fmt::format("sod: order, {:g} to {:g} mm", 1e3 * spacings[k - 1], 1e3 * spacings[k]),
        order(errors, k), 0.9, 0.2, "-",
        fmt::format("density errors {:.3g}, {:.3g}", errors[k - 1].density, errors[k].density)));
  add_two_spacings(spacings, results);
  return results;
}

}  // namespace moraine
