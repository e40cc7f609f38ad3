// What must go wrong: shocks without viscosity, expansion with a constant smoothing length.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "exact/hugoniot.hpp"
#include "exact/riemann_ideal_gas.hpp"
#include "exact/slab_release.hpp"
#include "exact/uniaxial_solid.hpp"
#include "setup/build_model.hpp"
#include "setup/check_strength.hpp"
#include "setup/materials.hpp"
#include "verify/l1_errors.hpp"
#include "verify/shipped_cases.hpp"
#include "verify/thrown_block.hpp"

namespace moraine {
namespace {

/// How many particles of a line stand behind the one that they started in front of.
int passed(ParticleStore const& store) {
  std::vector<std::pair<std::uint64_t, double>> line;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    line.emplace_back(store.id()[i], store.component(Field::position, 0)[i]);
  std::sort(line.begin(), line.end());
  int count = 0;
  for (std::size_t k = 1; k < line.size(); ++k) count += line[k].second < line[k - 1].second;
  return count;
}

struct Tube {
  double velocity_error = 0.0;  // L1
  int passed = 0;
};

Tube sod_tube(double spacing, bool viscous) {
  RiemannIdealGas const exact({1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, 1.4);
  Case c = shipped_case("sod");
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = 2.0;
  c.numerics.smoothing.mode = SmoothingMode::density;
  c.numerics.smoothing.most = 4.0;
  if (!viscous) c.numerics.viscosity_alpha = c.numerics.viscosity_beta = 0.0;
  Simulation const simulation = run_to_end(c);
  return {l1_errors(simulation, FlowCoordinate::x,
                    [&](double x) { return exact.sample(x / simulation.time()); })
              .velocity,
          passed(simulation.particles())};
}

void add_viscosity(std::vector<CheckResult>& results) {
  Tube const coarse = sod_tube(2e-3, false), fine = sod_tube(1e-3, false);
  Tube const viscous = sod_tube(1e-3, true);
  results.push_back(
      below("no viscosity: order of the velocity: none",
            convergence_order(coarse.velocity_error, fine.velocity_error), 0.25, "-",
            fmt::format("sod, L1 errors {:.3g}, {:.3g} at 2 and 1 mm; {:.3g} with viscosity",
                        coarse.velocity_error, fine.velocity_error, viscous.velocity_error)));
  results.push_back(at_most("no viscosity: particles that pass with / without it",
                            static_cast<double>(viscous.passed) / static_cast<double>(fine.passed),
                            0.1, "-",
                            fmt::format("{} of 1000 stand behind their neighbour without, {} with",
                                        fine.passed, viscous.passed)));
}

/// L1 error of the velocity of a slab of TNT that has burnt in an instant, released into nothing.
double release_error(double spacing, SmoothingMode mode) {
  Case c = shipped_case("tnt-slab");
  Jwl const tnt = std::get<Jwl>(c.materials.front().eos);
  c.materials.front().burn.kind = BurnKind::instantaneous;
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = 1.2;
  c.numerics.smoothing = {
      .mode = mode, .of_pair = PairSmoothing::geometric, .least = 0.5, .most = 8.0};
  SlabRelease const exact({tnt, tnt.reference_density, 0.0, tnt.reference_energy}, std::nullopt,
                          0.1);
  Simulation const simulation = run_to_end(c);
  return l1_errors(simulation, FlowCoordinate::x,
                   [&](double x) { return exact.sample(x, simulation.time()); })
      .velocity;
}

void add_constant_length(std::vector<CheckResult>& results) {
  double const coarse = release_error(0.4e-3, SmoothingMode::constant);
  double const fine = release_error(0.2e-3, SmoothingMode::constant);
  double const variable = release_error(0.2e-3, SmoothingMode::density);
  results.push_back(
      below("constant h of 1.2 spacings: order of the velocity: none",
            convergence_order(coarse, fine), 0.25, "-",
            fmt::format("products into nothing, L1 errors {:.3g}, {:.3g} at 0.4 and 0.2 mm", coarse,
                        fine)));
  results.push_back(at_most("constant h of 1.2 spacings: error of variable / constant h",
                            variable / fine, 0.25, "-",
                            fmt::format("L1 errors {:.3g}, {:.3g} at 0.2 mm", variable, fine)));
}

/// L1 error of the velocity of loose sand that is thrown against a wall at 300 m/s, when the shock
/// should have come to 0.4 of the block.
double thrown_sand_error(double spacing, bool viscous) {
  constexpr double u = 300.0;  // m/s
  MaterialSpec const& sand = shipped_material("sand_loose").spec;
  UniaxialSolid const solid{sand.eos, strength_of(sand.strength)};
  double const shock =
      shock_from_piston(Law(solid), reference_density(sand.eos), reference_energy(sand.eos), u)
          .shock_speed -
      u;  // over the wall
  Case c = thrown_block(sand, u, spacing);
  if (!viscous) c.numerics.viscosity_alpha = c.numerics.viscosity_beta = 0.0;
  c.time.end = 0.4 * block_length / shock;
  Simulation const simulation = run_to_end(c);
  auto const exact = [&](double x) -> std::optional<FlowState> {
    if (x > 0.8 * block_length) return std::nullopt;  // the free end
    return FlowState{
        .density = 1.0, .velocity = x < shock * simulation.time() ? 0.0 : -u, .pressure = 1.0};
  };
  return l1_errors(simulation, FlowCoordinate::x, exact).velocity;
}

void add_viscosity_in_soil(std::vector<CheckResult>& results) {
  double const coarse = thrown_sand_error(4e-3, false), fine = thrown_sand_error(2e-3, false);
  double const viscous = thrown_sand_error(2e-3, true);
  results.push_back(below(
      "no viscosity in sand: order of the velocity: none", convergence_order(coarse, fine), 0.25,
      "-", fmt::format("thrown at a wall, L1 errors {:.3g}, {:.3g} at 4 and 2 mm", coarse, fine)));
  results.push_back(at_most("no viscosity in sand: error with / without it", viscous / fine, 0.25,
                            "-", fmt::format("L1 errors {:.3g}, {:.3g} at 2 mm", viscous, fine)));
}

}  // namespace

std::vector<CheckResult> check_negative_controls(Effort) {
  std::vector<CheckResult> results;
  add_viscosity(results);
  add_constant_length(results);
  add_viscosity_in_soil(results);
  return results;
}

}  // namespace moraine
