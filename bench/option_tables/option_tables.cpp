// Measures what the options of [numerics] and the kernels do, and prints the tables of
// docs/options.md. Runs on one thread, about two minutes.
#include <fmt/core.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "exact/riemann_ideal_gas.hpp"
#include "probes/point_probe.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "step/simulation_error.hpp"
#include "verify/l1_errors.hpp"
#include "verify/shipped_cases.hpp"
#include "verify/vortex_decay.hpp"
#include "verify/wave_decay.hpp"

namespace moraine {
namespace {

/// A line of a table: its name, and what it changes in a case.
struct Variant {
  std::string name;
  std::function<void(Numerics&)> choose;
};

using Seconds = std::chrono::duration<double>;

/// The cells that `measure` makes, or `width` times that a guard stopped the run.
template <class Measure>
std::string cells(int width, Measure&& measure) {
  try {
    return measure();
  } catch (SimulationError const&) {
    std::string stopped;
    for (int k = 0; k < width; ++k) stopped += " stopped |";
    return stopped;
  }
}

double drift_of(Simulation const& simulation, double before) {
  return (simulation.sums().total_energy() - before) / before;
}

/// Sod's tube as shipped: L1 error of the density, energy gained / energy.
std::string tube(Variant const& variant) {
  return cells(2, [&] {
    Case c = shipped_case("sod");
    variant.choose(c.numerics);
    Simulation const simulation = run_to_end(c);
    RiemannIdealGas const exact({1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, 1.4);
    double const error = l1_errors(simulation, FlowCoordinate::x, [&](double x) {
                           return exact.sample(x / simulation.time());
                         }).density;
    return fmt::format(" {:.2f} % | {:.0e} |", 100.0 * error, drift_of(simulation, 1.375));
  });
}

/// The tank of water at rest with rows of 12.5 mm for half a second: the largest error of the
/// pressure at the end below the upper three rows / rho g H, energy gained / potential energy,
/// milliseconds of a step.
std::string still_water(Variant const& variant) {
  return cells(3, [&] {
    constexpr double depth = 0.5;  // m
    Case c = shipped_case("hydrostatic-tank");
    c.numerics.spacing = 0.0125;
    c.time.end = 0.5;
    variant.choose(c.numerics);
    Simulation simulation(build_model(c));
    double const before = simulation.sums().total_energy();
    auto const start = std::chrono::steady_clock::now();
    while (simulation.running()) simulation.advance();
    Seconds const spent = std::chrono::steady_clock::now() - start;
    ParticleStore const& store = simulation.particles();
    double worst = 0.0;
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
      double const z = store.component(Field::position, 1)[i];
      if (z > depth - 3.0 * c.numerics.spacing) continue;
      double const weight = 1000.0 * 9.81 * (depth - z);
      worst = std::max(worst, std::fabs(store.scalar(Field::pressure)[i] - weight));
    }
    return fmt::format(" {:.1f} % | {:+.1e} | {:.2f} |", 100.0 * worst / (9810.0 * depth),
                       drift_of(simulation, before),
                       1e3 * spent.count() / static_cast<double>(simulation.step()));
  });
}

/// Taylor-Green vortices as shipped: error of the decay until 1 s and of the velocities then,
/// energy gained / energy of the vortices, milliseconds of a step.
std::string vortices(Variant const& variant) {
  return cells(4, [&] {
    Case c = shipped_case("taylor-green");
    variant.choose(c.numerics);
    auto const start = std::chrono::steady_clock::now();
    VortexRun const run = run_vortices(c, {1.0});
    Seconds const spent = std::chrono::steady_clock::now() - start;
    return fmt::format(" {:+.1f} % | {:.1f} % | {:+.0e} | {:.2f} |", 100.0 * run.samples[0].excess,
                       100.0 * run.samples[0].velocity, run.energy_drift,
                       1e3 * spent.count() / static_cast<double>(run.steps));
  });
}

/// The standing wave as shipped: error of the period, loss in a period, energy gained / its own.
std::string wave(Variant const& variant) {
  return cells(3, [&] {
    Case c = shipped_case("standing-wave");
    variant.choose(c.numerics);
    WaveRun const run = run_wave(c, 2);
    if (std::fabs(run.period) > 0.1) return std::string(" broken | broken | broken |");
    return fmt::format(" {:+.2f} % | {:.2f} % | {:+.0e} |", 100.0 * run.period, 100.0 * run.loss,
                       run.energy_drift);
  });
}

/// Share of the particles of a material whose nearest neighbour is of another.
double mixed(ParticleStore const& store, MaterialId material) {
  auto const x = store.component(Field::position, 0);
  auto const y = store.component(Field::position, 1);
  std::size_t const count = store.range(Kind::fluid).size();
  double among_others = 0.0, all = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (store.material()[i] != material) continue;
    std::size_t nearest = i;
    double least2 = 1e300;
    for (std::size_t j = 0; j < count; ++j) {
      double const r2 = std::pow(x[i] - x[j], 2) + std::pow(y[i] - y[j], 2);
      if (j == i || r2 >= least2) continue;
      least2 = r2;
      nearest = j;
    }
    all += 1.0;
    among_others += store.material()[nearest] != material ? 1.0 : 0.0;
  }
  return among_others / all;
}

/// TNT in water as shipped until 200 us: share of gas among water, peak pressures at 15 and 30 cm,
/// energy gained / energy, steps.
std::string charge(Variant const& variant) {
  return cells(5, [&] {
    Case c = shipped_case("tnt-in-water");
    variant.choose(c.numerics);
    c.time.end = 200e-6;
    MaterialId const gas = std::holds_alternative<Jwl>(c.materials[0].eos) ? 0 : 1;
    Simulation simulation(build_model(c));
    double const before = simulation.sums().total_energy();
    double near = 0.0, far = 0.0;
    auto const read = [&](double x, double& peak) {
      peak = std::max(peak, probe_point(simulation.particles(), c.numerics.kernel,
                                        c.numerics.smoothing_length(), {x, 0.0, 0.0})
                                .pressure);
    };
    while (simulation.running()) {
      simulation.advance();
      read(0.15, near);
      read(0.30, far);
    }
    return fmt::format(" {:.0f} % | {:.2f} GPa | {:.3f} GPa | {:+.0e} | {} |",
                       100.0 * mixed(simulation.particles(), gas), 1e-9 * near, 1e-9 * far,
                       drift_of(simulation, before), simulation.step());
  });
}

void print_table(std::string const& head, std::vector<Variant> const& variants,
                 std::vector<std::function<std::string(Variant const&)>> const& columns) {
  fmt::print("\n{}\n|", head);
  for (char const letter : head)
    if (letter == '|') fmt::print("---|");
  fmt::print("\n");
  for (Variant const& variant : variants) {
    std::string line = fmt::format("| {} |", variant.name);
    for (auto const& column : columns) line += column(variant);
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }
}

std::vector<Variant> densities() {
  return {{"`continuity`, `mass`", [](Numerics& n) { n.continuity = ContinuityForm::mass; }},
          {"`continuity`, `volume`", [](Numerics& n) { n.continuity = ContinuityForm::volume; }},
          {"`continuity`, `volume` with `momentum = \"mixed\"`",
           [](Numerics& n) {
             n.continuity = ContinuityForm::volume;
             n.momentum = MomentumForm::mixed;
           }},
          {"`summation`",
           [](Numerics& n) {
             n.density = DensityForm::summation;
             n.density_diffusion = 0.0;
           }},
          {"`normalised`", [](Numerics& n) {
             n.density = DensityForm::normalised;
             n.density_diffusion = 0.0;
           }}};
}

std::vector<Variant> options() {
  auto const nothing = [](Numerics& n) { n.shifting = 0.0; };
  auto const corrected = [](Numerics& n) { n.gradient_correction = GradientCorrection::bonet_lok; };
  return {{"none", nothing},
          {"`xsph = 0.5`",
           [=](Numerics& n) {
             nothing(n);
             n.xsph = 0.5;
           }},
          {"`shifting = 20`", [](Numerics& n) { n.shifting = 20.0; }},
          {"`shifting = 40`", [](Numerics& n) { n.shifting = 40.0; }},
          {"`gradient_correction`",
           [=](Numerics& n) {
             nothing(n);
             corrected(n);
           }},
          {"`gradient_correction`, `shifting = 20`",
           [=](Numerics& n) {
             corrected(n);
             n.shifting = 20.0;
           }},
          {"`density_diffusion = 0.1`, `hydrostatic`",
           [=](Numerics& n) {
             nothing(n);
             n.density_diffusion = 0.1;
           }},
          {"`density_diffusion = 0.1`, `gradient`",
           [=](Numerics& n) {
             nothing(n);
             n.density_diffusion = 0.1;
             n.diffusion = DiffusionForm::gradient;
           }},
          {"`density_diffusion = 0.1`, `gradient`, `shifting = 40`", [](Numerics& n) {
             n.shifting = 40.0;
             n.density_diffusion = 0.1;
             n.diffusion = DiffusionForm::gradient;
           }}};
}

std::vector<Variant> penalties() {
  auto const of = [](double strength) {
    return [strength](Numerics& n) { n.penalty.strength = strength; };
  };
  return {{"0", of(0.0)}, {"1e5", of(1e5)}, {"1e6", of(1e6)}, {"1e7", of(1e7)}};
}

std::vector<Variant> kernels() {
  std::vector<Variant> variants;
  for (KernelInfo const& kernel : kernel_table)
    variants.push_back(
        {fmt::format("`{}`", kernel.name), [kernel](Numerics& n) { n.kernel = kernel.kernel; }});
  return variants;
}

}  // namespace

int print_option_tables() {
  omp_set_num_threads(1);
  print_table("| density | sod, density | energy | still water, pressure | energy | ms a step |",
              densities(), {tube, still_water});
  print_table(
      "| options | vortices, decay | velocities | energy | ms a step | wave, period | loss | "
      "energy | still water, pressure | energy | ms a step |",
      options(), {vortices, wave, still_water});
  print_table("| `penalty.strength` | gas among water | peak at 15 cm | 30 cm | energy | steps |",
              penalties(), {charge});
  print_table(
      "| kernel | sod, density | energy | vortices, decay | velocities | energy | ms a step |",
      kernels(), {tube, vortices});
  return 0;
}

}  // namespace moraine

int main() { return moraine::print_option_tables(); }
