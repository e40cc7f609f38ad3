#include "verify/check.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

#include "base/input_error.hpp"

namespace moraine {

// One folder each below verify/; the function is defined in its check.cpp.
std::vector<CheckResult> check_sod(Effort effort);
std::vector<CheckResult> check_toro(Effort effort);
std::vector<CheckResult> check_water_hugoniot(Effort effort);
std::vector<CheckResult> check_elastic_waves(Effort effort);
std::vector<CheckResult> check_point_paths(Effort effort);
std::vector<CheckResult> check_soil_shocks(Effort effort);
std::vector<CheckResult> check_surface_charge(Effort effort);
std::vector<CheckResult> check_compaction(Effort effort);
std::vector<CheckResult> check_momentum_double(Effort effort);
std::vector<CheckResult> check_momentum_mixed(Effort effort);
std::vector<CheckResult> check_energy_order(Effort effort);
std::vector<CheckResult> check_hydrostatic_pressure(Effort effort);
std::vector<CheckResult> check_sloshing(Effort effort);
std::vector<CheckResult> check_viscous_flow(Effort effort);
std::vector<CheckResult> check_taylor_green(Effort effort);
std::vector<CheckResult> check_standing_wave(Effort effort);
std::vector<CheckResult> check_walls(Effort effort);
std::vector<CheckResult> check_martin_moyce_front(Effort effort);
std::vector<CheckResult> check_noh(Effort effort);
std::vector<CheckResult> check_sedov(Effort effort);
std::vector<CheckResult> check_tnt_in_water(Effort effort);
std::vector<CheckResult> check_tnt_kernels(Effort effort);
std::vector<CheckResult> check_tnt_slab(Effort effort);
std::vector<CheckResult> check_tnt_water_interface(Effort effort);
std::vector<CheckResult> check_negative_controls(Effort effort);
std::vector<CheckResult> check_undex_cole(Effort effort);
std::vector<CheckResult> check_kleefsman(Effort effort);

namespace {

constexpr std::array all_checks{
    Check{"sod", "a shock tube agrees with the exact solution and converges to it", check_sod},
    Check{"toro",
          "five shock tubes, up to a hundred thousandfold jump of pressure, are exact to 3 %",
          check_toro},
    Check{"water-hugoniot",
          "shocks in water have the speed, pressure and density of the jump "
          "conditions",
          check_water_hugoniot},
    Check{"elastic-waves", "waves in an elastic solid run at the speeds of its constants",
          check_elastic_waves},
    Check{"point-paths", "one point of a soil bears in laboratory tests what closed forms say",
          check_point_paths},
    Check{"soil-shocks",
          "shocks in soils and a metal have the speed, stress and density of the jump conditions",
          check_soil_shocks},
    Check{"surface-charge",
          "a charge on soil keeps energy and symmetry, penetrates nothing, and arrives in time",
          check_surface_charge},
    Check{"compaction",
          "waves that crush pores have the speed, pressure and density of the jump conditions, and "
          "what they crushed stays so",
          check_compaction},
    Check{"momentum-double", "pairs conserve momentum to 1e-14 in double precision",
          check_momentum_double},
    Check{"momentum-mixed", "pairs conserve momentum to 1e-6 in mixed precision",
          check_momentum_mixed},
    Check{"energy-order", "the drift of total energy is of second order in the time step",
          check_energy_order},
    Check{"hydrostatic-pressure", "still water has the pressure rho g z and stays still",
          check_hydrostatic_pressure},
    Check{"sloshing", "water in a swaying tank moves as linear potential theory says",
          check_sloshing},
    Check{"viscous-flow", "liquid between two plates flows as the series solutions say",
          check_viscous_flow},
    Check{"taylor-green", "vortices decay as fast as viscosity says", check_taylor_green},
    Check{"standing-wave", "a small wave keeps its period and its amplitude", check_standing_wave},
    Check{"walls",
          "walls that mirror the fluid keep water still and reflect sound; none leak or heat",
          check_walls},
    Check{"martin-moyce-front", "the front of a dam break advances as measured",
          check_martin_moyce_front},
    Check{"noh",
          "cold gas that implodes is stopped behind the exact shock, in the limit of fine spacing",
          check_noh},
    Check{"sedov", "blasts from a plane, an axis and a point come to the exact radius",
          check_sedov},
    Check{"tnt-in-water",
          "an explosion keeps energy, momentum and symmetry, and its shock is possible",
          check_tnt_in_water},
    Check{
        "tnt-kernels",
        "a charge in water keeps its energy with every kernel, in every dimension, with both forms "
        "of momentum and smoothing lengths that vary",
        check_tnt_kernels},
    Check{"tnt-slab",
          "a slab of explosive burns behind a Chapman-Jouguet front, or expands as burnt at once",
          check_tnt_slab},
    Check{"tnt-water-interface",
          "a detonation, and products burnt at once, send into water what the jump conditions say",
          check_tnt_water_interface},
    Check{"negative-controls",
          "without viscosity, and with constant smoothing lengths in expansion, errors stay",
          check_negative_controls},
    Check{"undex-cole", "the shock of a sphere of TNT in water has the peaks that were measured",
          check_undex_cole},
    Check{"kleefsman", "a dam break hits a box as measured, and the water comes back as measured",
          check_kleefsman},
};

}  // namespace

Verdict CheckResult::verdict() const {
  if (skipped) return Verdict::skip;
  if (pass) return Verdict::pass;
  bool const known = !explained_in.empty() && std::fabs(measured - reference) <= worst;
  return known ? Verdict::known : Verdict::fail;
}

CheckResult compare(std::string name, double measured, double reference, double tolerance,
                    std::string unit, std::string note) {
  bool const pass = std::fabs(measured - reference) <= tolerance;  // false for what is no number
  return {.name = std::move(name),
          .measured = measured,
          .reference = reference,
          .tolerance = tolerance,
          .unit = std::move(unit),
          .pass = pass,
          .note = std::move(note)};
}

CheckResult skip(std::string name, std::string why) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  CheckResult result = compare(std::move(name), nothing, nothing, nothing, "-", std::move(why));
  result.skipped = true;
  return result;
}

CheckResult at_most(std::string name, double measured, double limit, std::string unit,
                    std::string note) {
  return compare(std::move(name), measured, 0.0, limit, std::move(unit), std::move(note));
}

CheckResult below(std::string name, double measured, double limit, std::string unit,
                  std::string note) {
  CheckResult result =
      compare(std::move(name), measured, limit, 0.0, std::move(unit), std::move(note));
  result.from_below = true;
  result.pass = measured <= limit;
  return result;
}

CheckResult explained(CheckResult result, double worst, std::string page) {
  result.worst = worst;
  result.explained_in = std::move(page);
  return result;
}

std::span<Check const> checks() { return all_checks; }

std::optional<Check> find_check(std::string_view name) {
  for (Check const& check : all_checks)
    if (check.name == name) return check;
  return std::nullopt;
}

std::vector<Check> choose_checks(std::vector<std::string> const& names) {
  if (names.empty()) return {checks().begin(), checks().end()};
  std::vector<std::string_view> known;
  for (Check const& check : checks()) known.push_back(check.name);
  std::vector<Check> chosen;
  std::vector<InputProblem> problems;
  for (std::string const& name : names) {
    if (auto const check = find_check(name))
      chosen.push_back(*check);
    else
      problems.push_back({"moraine verify", 0, 0, "", fmt::format("\"{}\"", name), "is not a check",
                          name_hint(name, known)});
  }
  if (!problems.empty()) throw InputErrors(std::move(problems));
  return chosen;
}

std::vector<CheckResult> run_check(Check const& check, Effort effort) {
  try {
    return check.run(effort);
  } catch (std::exception const& error) {
    return {compare(std::string(check.name), std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0,
                    "-", error.what())};
  }
}

}  // namespace moraine
