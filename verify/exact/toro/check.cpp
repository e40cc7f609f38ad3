// Toro's five shock tubes against the exact solution of the Riemann problem.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/shock_tubes.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/l1_errors.hpp"
#include "verify/profile.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

constexpr double ratio = 1.4;  // of the heat capacities

/// Tests 2 to 5 are those of the list; the first of its table is Sod's tube, which is a check of
/// its own. Here it is the one with a moving gas of Toro's table 6.2.
std::array<ShockTube, 5> tubes() {
  std::array<ShockTube, 5> list;
  std::copy(shock_tubes.begin() + 1, shock_tubes.end(), list.begin());
  list[0] = {"toro-1", "moving gas, sonic rarefaction", {1.0, 0.75, 1.0}, {0.125, 0.0, 0.1}, 0.3,
             0.2};
  return list;
}

/// A length [m] made longer, to a whole number of 5 cm.
double rounded_up(double length) { return 0.05 * std::ceil(length / 0.05); }

double energy(GasState const& gas) { return gas.pressure / ((ratio - 1.0) * gas.density); }

RegionSpec filled(char const* name, double from, double to, GasState const& gas) {
  RegionSpec region{name, "gas", Box{{from, 0.0, 0.0}, {to, 0.0, 0.0}}, {}};
  region.initial.velocity = {gas.velocity, 0.0, 0.0};
  region.initial.density = gas.density;
  region.initial.specific_energy = energy(gas);
  return region;
}

/// The tube at this spacing of the gas on the left. Its ends go with the gas and start so far out
/// that the tube from 0 to 1 m is still full at the end.
Case case_of(ShockTube const& tube, double spacing) {
  Case c = shipped_case("toro");
  double const low = -rounded_up(std::max(0.0, tube.left.velocity) * tube.time);
  double const high = 1.0 + rounded_up(std::max(0.0, -tube.right.velocity) * tube.time);
  c.numerics.spacing = spacing;
  c.time.end = tube.time;
  c.regions = {filled("left", low, tube.membrane, tube.left),
               filled("right", tube.membrane, high, tube.right)};
  c.regions[1].equal_mass_with = "left";
  for (std::size_t side = 0; side < 2; ++side) {
    WallSpec& wall = c.walls[side];
    wall.box = {{low, 0.0, 0.0}, {high, 0.0, 0.0}};
    double const speed = side == 0 ? tube.left.velocity : tube.right.velocity;
    wall.motion.motion.reset();
    if (speed == 0.0) continue;
    RigidMotion motion;
    motion.translation[0] = TimeCourse::formula(fmt::format("{:.17g} * t", speed), tube.time);
    wall.motion.motion = motion;
  }
  return c;
}

/// Spreads the jump of the specific energy over two smoothing lengths (README.md).
void spread_jump(Model& model, ShockTube const& tube) {
  auto const x = model.particles.component(Field::position, 0);
  auto e = model.particles.scalar(Field::specific_energy);
  double const width = 2.0 * model.numerics.smoothing_length();
  for (std::size_t i = 0; i < model.particles.range(Kind::fluid).size(); ++i) {
    double const right = std::clamp(0.5 + (x[i] - tube.membrane) / width, 0.0, 1.0);
    e[i] = (1.0 - right) * energy(tube.left) + right * energy(tube.right);
  }
}

Simulation run_tube(ShockTube const& tube, Case const& c) {
  Model model = build_model(c);
  spread_jump(model, tube);
  Simulation simulation(std::move(model));
  while (simulation.running()) simulation.advance();
  return simulation;
}

L1Errors errors_of(ShockTube const& tube, Simulation const& simulation) {
  RiemannIdealGas const exact(tube.left, tube.right, ratio);
  return l1_errors(simulation, FlowCoordinate::x, [&](double x) -> std::optional<FlowState> {
    if (x < 0.0 || x > 1.0) return std::nullopt;
    return exact.sample((x - tube.membrane) / simulation.time());
  });
}

std::string density_errors(L1Errors const& coarse, L1Errors const& fine, double spacing) {
  return fmt::format("density errors {:.3g}, {:.3g} at {:g} and {:g} mm", coarse.density,
                     fine.density, 2e3 * spacing, 1e3 * spacing);
}

/// The middle of the gas that the fast shock of the fifth test has compressed 5.18 times.
CheckResult behind_fast_shock(ShockTube const& tube, Simulation const& simulation) {
  RiemannIdealGas const exact(tube.left, tube.right, ratio);
  double const contact = tube.membrane + exact.star_velocity() * simulation.time();
  double const reference = exact.sample(exact.star_velocity()).density;
  return compare("toro-5: density behind the fast shock",
                 mean_between(simulation, Field::density, contact + 0.03, contact + 0.09),
                 reference, 0.03 * reference, "kg/m^3", "mean, 3 to 9 cm from the contact");
}

void add_tube(ShockTube const& tube, double spacing, std::vector<CheckResult>& results) {
  L1Errors const coarse = errors_of(tube, run_tube(tube, case_of(tube, 2.0 * spacing)));
  Simulation const simulation = run_tube(tube, case_of(tube, spacing));
  L1Errors const fine = errors_of(tube, simulation);
  std::string const name(tube.name);
  std::string const at = fmt::format("L1, {:g} mm, {}", 1e3 * spacing, tube.meaning);
  results.push_back(at_most(name + ": density", fine.density, 0.03, "-", at));
  results.push_back(at_most(name + ": velocity", fine.velocity, 0.03, "-", at));
  results.push_back(at_most(name + ": pressure", fine.pressure, 0.03, "-", at));
  results.push_back(compare(name + ": order", convergence_order(coarse.density, fine.density), 0.8,
                            0.3, "-", density_errors(coarse, fine, spacing)));
  if (name == "toro-5") results.push_back(behind_fast_shock(tube, simulation));
}

/// Density as a sum has no error behind the shock that stays.
void add_sums(ShockTube const& tube, double spacing, std::vector<CheckResult>& results) {
  auto const summed = [&](double at) {
    Case c = case_of(tube, at);
    c.numerics.density = DensityForm::summation;
    return run_tube(tube, c);
  };
  L1Errors const coarse = errors_of(tube, summed(2.0 * spacing));
  Simulation const fine = summed(spacing);
  L1Errors const errors = errors_of(tube, fine);
  std::string const name = std::string(tube.name) + ", density as a sum";
  results.push_back(compare(name + ": order", convergence_order(coarse.density, errors.density),
                            0.8, 0.3, "-", density_errors(coarse, errors, spacing)));
  CheckResult behind = behind_fast_shock(tube, fine);
  results.push_back(compare(name + ": behind the fast shock", behind.measured, behind.reference,
                            2e-3 * behind.reference, behind.unit, behind.note));
}

/// Two ways in which strong shocks go wrong with smoothing lengths that vary.
void add_controls(ShockTube const& tube, double spacing, std::vector<CheckResult>& results) {
  auto const add = [&](char const* what, auto&& change) {
    auto const changed = [&](double at) {
      Case c = case_of(tube, at);
      change(c.numerics);
      return errors_of(tube, run_tube(tube, c));
    };
    L1Errors const coarse = changed(2.0 * spacing), fine = changed(spacing);
    results.push_back(below(fmt::format("{}: order, {}: none", tube.name, what),
                            convergence_order(coarse.density, fine.density), 0.25, "-",
                            density_errors(coarse, fine, spacing)));
  };
  add("volume form", [](Numerics& numerics) { numerics.continuity = ContinuityForm::volume; });
  add("arithmetic mean of h",
      [](Numerics& numerics) { numerics.smoothing.of_pair = PairSmoothing::arithmetic; });
}

}  // namespace

std::vector<CheckResult> check_toro(Effort effort) {
  std::vector<CheckResult> results;
  double const refinement = effort == Effort::full ? 0.5 : 1.0;
  auto const list = tubes();
  // The thin gas of the first is eight times as coarse, that of the second becomes so.
  for (std::size_t k = 0; k < 2; ++k) add_tube(list[k], 1.25e-3 * refinement, results);
  for (std::size_t k = 2; k < 4; ++k) add_tube(list[k], 2.5e-3 * refinement, results);
  add_tube(list.back(), 2.5e-3, results);  // finer spacings meet a floor (README.md)
  add_sums(list.back(), 2.5e-3 * refinement, results);
  add_controls(list.back(), 2.5e-3, results);
  return results;
}

}  // namespace moraine
