// Decaying vortices in a periodic square.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

#include "verify/shipped_cases.hpp"
#include "verify/vortex_decay.hpp"

namespace moraine {
namespace {

constexpr double half = 0.5;  // s; energies have fallen to 0.45

std::string note_of(VortexRun const& run) {
  return fmt::format("decay of the energy until {:g} s / exact, - 1; velocities off by {:.2g}",
                     run.samples.back().time, run.samples.back().velocity);
}

VortexRun corrected(int across, std::vector<double> const& times) {
  Case c = shipped_case("taylor-green");
  c.numerics.spacing = 1.0 / across;
  c.numerics.gradient_correction = GradientCorrection::bonet_lok;
  c.numerics.shifting = 20.0;  // enough with corrected gradients (README.md)
  return run_vortices(c, times);
}

CheckResult order(VortexRun const& coarse, VortexRun const& fine, int across) {
  double const one = coarse.samples.front().excess;
  double const two = fine.samples.front().excess;
  return compare(
      fmt::format("taylor-green: order, gradient_correction, {} to {} across", across / 2, across),
      std::log2(std::fabs(one / two)), 1.5, 0.5, "-",
      fmt::format("of the decay until 0.5 s, off by {:.2g}, {:.2g}", one, two));
}

CheckResult central(Case c, std::vector<double> const& times) {
  c.numerics.physical_viscosity = ViscosityForm::monaghan_cleary;
  c.numerics.smoothing_factor = 2.5;
  VortexRun const run = run_vortices(c, times);
  return at_most("taylor-green: decay, monaghan_cleary", run.samples.back().excess, 0.02, "-",
                 note_of(run));
}

CheckResult without_shifting(Case c) {
  c.numerics.shifting = 0.0;
  VortexRun const run = run_vortices(c, {half});
  return compare("taylor-green: without shifting (negative control)", run.samples.back().excess,
                 1.0, 0.6, "-", note_of(run));
}

}  // namespace

std::vector<CheckResult> check_taylor_green(Effort effort) {
  bool const full = effort == Effort::full;
  std::vector<double> const times = full ? std::vector{half, 1.0} : std::vector{half};
  Case const c = shipped_case("taylor-green");
  VortexRun const shifted = run_vortices(c, times);
  VortexRun const middle = corrected(50, times);
  std::vector<CheckResult> results{
      at_most("taylor-green: decay", shifted.samples.back().excess, 0.02, "-", note_of(shifted)),
      at_most("taylor-green: decay, gradient_correction", middle.samples.back().excess, 0.02, "-",
              note_of(middle)),
      order(corrected(25, {half}), middle, 50)};
  if (full) {
    results.push_back(order(middle, corrected(100, {half}), 100));
    results.push_back(central(c, times));
  }
  results.push_back(at_most("taylor-green: momentum", shifted.momentum, 1e-6, "m/s",
                            "of all particles, by their mass; largest velocity 1 m/s"));
  results.push_back(without_shifting(c));
  return results;
}

}  // namespace moraine
