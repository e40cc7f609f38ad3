// A charge in water with every kernel, in every dimension, with both forms of momentum, and with
// smoothing lengths that vary in every way.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "setup/build_model.hpp"
#include "setup/read_case.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

constexpr std::array<std::string_view, 4> mean_names{"arithmetic", "geometric", "largest",
                                                     "smallest"};

/// A corner that is the same along all axes.
std::string corner(int dimension, double value) {
  std::string text = "[";
  for (int axis = 0; axis < dimension; ++axis)
    text += fmt::format("{}{}", axis == 0 ? "" : ", ", value);
  return text + "]";
}

/// 10 cm of TNT in the middle of a box of water, in 3D a smaller box.
Case charge_in_water(int dimension, Effort effort) {
  double const half_box = dimension == 3 ? 0.2 : 0.5;
  double const spacing = dimension == 1 ? 0.005 : (dimension == 2 ? 0.02 : 0.025);
  double const end = effort == Effort::full ? 200e-6 : 60e-6;
  std::string const text = fmt::format(
      R"(
space.dimension = {}
resolution = {{ spacing = {}, smoothing_factor = 2.0 }}
time.end = {}
[material.water]
eos = "water_polynomial"
[material.tnt]
eos = "jwl"
[[region]]
name = "water"
material = "water"
box = {{ min = {box_min}, max = {box_max} }}
[[region]]
name = "charge"
material = "tnt"
box = {{ min = {charge_min}, max = {charge_max} }}
[[wall]]
name = "box"
container = {{ min = {box_min}, max = {box_max} }}
)",
      dimension, spacing, end, fmt::arg("box_min", corner(dimension, -half_box)),
      fmt::arg("box_max", corner(dimension, half_box)),
      fmt::arg("charge_min", corner(dimension, -0.05)),
      fmt::arg("charge_max", corner(dimension, 0.05)));
  return parse_case(text, "tnt-kernels");
}

/// Largest change of the total energy over that of the charge; not a number if a guard stops the
/// run.
double energy_error(Case const& c) {
  Simulation simulation(build_model(c));
  ParticleStore const& store = simulation.particles();
  double charge = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (store.material()[i] == 1)
      charge += store.scalar(Field::mass)[i] * store.scalar(Field::specific_energy)[i];
  double const start = simulation.sums().total_energy();
  double worst = 0.0;
  try {
    while (simulation.running()) {
      simulation.advance();
      if (simulation.step() % 10 != 0 && simulation.running()) continue;
      worst = std::max(worst, std::fabs(simulation.sums().total_energy() - start) / charge);
    }
  } catch (std::exception const&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return worst;
}

/// The worst of several runs, with what made it.
struct Worst {
  double error = 0.0;
  std::string run;

  void include(double other, std::string what) {
    if (std::isnan(error) || other <= error) return;
    error = other;
    run = std::move(what);
  }
};

}  // namespace

std::vector<CheckResult> check_tnt_kernels(Effort effort) {
  std::vector<CheckResult> results;
  auto const add = [&](std::string_view name, Worst const& worst, int runs) {
    results.push_back(at_most(fmt::format("tnt-kernels: energy, {}", name), worst.error, 0.01, "-",
                              fmt::format("worst of {} runs: {}", runs, worst.run)));
  };
  for (KernelInfo const& kernel : kernel_table) {
    Worst worst;
    for (int dimension = 1; dimension <= 3; ++dimension)
      for (MomentumForm const form : {MomentumForm::conservative, MomentumForm::mixed}) {
        Case c = charge_in_water(dimension, effort);
        c.numerics.kernel = kernel.kernel;
        c.numerics.momentum = form;
        // Its force jumps where a neighbour comes or goes: energy needs a shorter step.
        if (kernel.kernel == KernelName::dome) c.time.courant = 0.15;
        worst.include(energy_error(c),
                      fmt::format("{}D, {} momentum", dimension,
                                  form == MomentumForm::mixed ? "mixed" : "conservative"));
      }
    add(kernel.name, worst, 6);
  }
  for (SmoothingMode const mode : {SmoothingMode::rate, SmoothingMode::density}) {
    Worst worst;
    for (int dimension = 1; dimension <= 3; ++dimension)
      for (PairSmoothing const of_pair : {PairSmoothing::arithmetic, PairSmoothing::geometric,
                                          PairSmoothing::largest, PairSmoothing::smallest}) {
        Case c = charge_in_water(dimension, effort);
        c.numerics.smoothing.mode = mode;
        c.numerics.smoothing.of_pair = of_pair;
        worst.include(energy_error(c), fmt::format("{}D, {} mean", dimension,
                                                   mean_names[static_cast<std::size_t>(of_pair)]));
      }
    add(mode == SmoothingMode::rate ? "h by rate" : "h by density", worst, 12);
  }
  return results;
}

}  // namespace moraine
