// Exact solutions for any material: Riemann problem, Hugoniot curves, detonation, release.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "app/exact_profile.hpp"
#include "app/exact_solution.hpp"
#include "exact/compaction.hpp"
#include "exact/detonation.hpp"
#include "exact/hugoniot.hpp"
#include "exact/slab_release.hpp"
#include "setup/materials.hpp"

namespace moraine {
namespace {

constexpr char const* menikoff_plohr = "Menikoff and Plohr, Rev. Mod. Phys. 61 (1989) 75";

/// Density, pressure, energy and velocity of a material, under these keys.
std::vector<ExactParameter> state_parameters(std::array<std::string_view, 4> const& keys,
                                             std::string_view meaning) {
  return {exact_number(keys[0], "", Quantity::density, ExactRange::positive, meaning),
          exact_number(keys[1], "", Quantity::pressure, ExactRange::any,
                       "without a density: decides it; with one: decides the energy"),
          exact_number(keys[2], "", Quantity::specific_energy, ExactRange::any, meaning),
          exact_number(keys[3], "0 m/s", Quantity::velocity, ExactRange::any, "towards larger x")};
}

RiemannSide side_of(ExactValues const& values, std::string const& name) {
  Eos const eos = shipped_material(values.text(name)).spec.eos;
  MaterialPoint const at = material_point(values, name + "_", eos);
  std::string const velocity = name + "_velocity";
  return {law_of_loaded(eos, at.density, at.specific_energy), at.density,
          values.has(velocity) ? values.number(velocity) : 0.0, at.specific_energy};
}

/// Nothing for a vacuum.
std::optional<RiemannSide> side_or_vacuum(ExactValues const& values, std::string const& name) {
  if (values.text(name) == "vacuum") return std::nullopt;
  return side_of(values, name);
}

ExactAnswer solve_riemann(ExactValues const& values) {
  RiemannSide const left = side_of(values, "left");
  auto const right = side_or_vacuum(values, "right");
  RiemannProblem const solution =
      right ? RiemannProblem(left, *right) : RiemannProblem::into_vacuum(left);
  double const t = values.number("time");
  return {riemann_numbers(solution, t, 0.0),
          flow_profile("x", riemann_places(solution, t, 0.0, values.points),
                       [&](double x) { return solution.sample(x / t); })};
}

ExactAnswer solve_slab(ExactValues const& values) {
  RiemannSide const charge = side_of(values, "explosive");
  double const thickness = values.number("thickness");
  SlabRelease const slab(charge, side_or_vacuum(values, "outside"), thickness);
  double const t = values.has("time") ? values.number("time") : 0.5 * slab.meeting_time();
  if (t > slab.meeting_time())
    throw std::invalid_argument(
        fmt::format("the time {:.6g} s is after the wave has met the wall; choose at most {:.6g} s",
                    t, slab.meeting_time()));
  FlowState const wall = slab.sample(0.0, t);
  std::vector<ExactNumber> numbers{{"time", t, "s"},
                                   {"pressure of the charge", wall.pressure, "Pa"},
                                   {"time when the wave meets the wall", slab.meeting_time(), "s"}};
  for (ExactNumber& number : riemann_numbers(slab.waves(), t, thickness))
    numbers.push_back(std::move(number));
  double const end = riemann_places(slab.waves(), t, thickness, 2).back();
  return {std::move(numbers), flow_profile("x", even_steps(0.0, end, values.points),
                                           [&](double x) { return slab.sample(x, t); })};
}

/// What runs ahead of compaction by the fastest piston.
void add_precursor(PAlpha const& porous, RiemannSide const& ahead, double piston,
                   std::vector<ExactNumber>& numbers) {
  auto const precursor =
      waves_from_piston(porous, ahead.density, ahead.specific_energy, piston).precursor;
  if (!precursor) return;
  numbers.push_back({"speed of its elastic precursor", precursor->behind.shock_speed, "m/s"});
  numbers.push_back({"pressure of the precursor", precursor->behind.pressure, "Pa"});
  numbers.push_back({"velocity behind the precursor", precursor->piston_velocity, "m/s"});
}

ExactAnswer solve_hugoniot(ExactValues const& values) {
  RiemannSide const ahead = side_of(values, "material");
  Eos const& eos = shipped_material(values.text("material")).spec.eos;
  auto const* porous = std::get_if<PAlpha>(&eos);
  double const fastest = values.number("fastest_piston");
  auto const curve =
      porous != nullptr
          ? compaction_curve(*porous, ahead.density, ahead.specific_energy, fastest, values.points)
          : hugoniot_curve(ahead.law, ahead.density, ahead.specific_energy, fastest, values.points);
  ExactAnswer answer;
  answer.profile = table_of({{"piston_velocity", "m/s"},
                             {"shock_speed", "m/s"},
                             {"density", "kg/m^3"},
                             {"pressure", "Pa"},
                             {"specific_energy", "J/kg"}});
  for (auto const& [behind, piston] : curve) {
    add_row(answer.profile,
            {piston, behind.shock_speed, behind.density, behind.pressure, behind.specific_energy});
  }
  auto const& [last, piston] = curve.back();
  answer.numbers = {{"density ahead", ahead.density, "kg/m^3"},
                    {"pressure ahead", curve.front().behind.pressure, "Pa"},
                    {"sound speed ahead", curve.front().behind.shock_speed, "m/s"},
                    {"fastest piston", piston, "m/s"},
                    {"its shock speed", last.shock_speed, "m/s"},
                    {"its pressure", last.pressure, "Pa"},
                    {"its density", last.density, "kg/m^3"}};
  if (porous != nullptr) add_precursor(*porous, ahead, piston, answer.numbers);
  return answer;
}

/// The explosive of a shipped material at its reference state.
Explosive explosive_of(ExactValues const& values) {
  Eos const eos = shipped_material(values.text("explosive")).spec.eos;
  return {eos, reference_density(eos), reference_energy(eos)};
}

std::vector<ExactNumber> detonation_numbers(Detonation const& found) {
  return {{"detonation velocity", found.speed, "m/s"},
          {"C-J pressure", found.behind.pressure, "Pa"},
          {"C-J density", found.behind.density, "kg/m^3"},
          {"C-J velocity", found.behind.velocity, "m/s"},
          {"C-J sound speed", found.sound_speed, "m/s"},
          {"C-J specific energy", found.behind.specific_energy, "J/kg"}};
}

ExactAnswer solve_cj(ExactValues const& values) {
  Explosive const explosive = explosive_of(values);
  Detonation const found = chapman_jouguet(explosive);
  ExactAnswer answer{detonation_numbers(found), {}};
  FlowState const& cj = found.behind;
  RiemannSide const products{explosive.products, cj.density, cj.velocity, cj.specific_energy};
  if (values.text("into") != "nothing") {
    auto const target = side_or_vacuum(values, "into");
    RiemannProblem const match =
        target ? RiemannProblem(products, *target) : RiemannProblem::into_vacuum(products);
    answer.numbers.push_back({"pressure at the interface", match.star_pressure(), "Pa"});
    answer.numbers.push_back({"velocity of the interface", match.star_velocity(), "m/s"});
    if (match.right_wave()) {
      answer.numbers.push_back({"speed of the wave sent on", match.right_wave()->head, "m/s"});
      answer.numbers.push_back(
          {"density behind the wave sent on", match.right_wave()->behind.density, "kg/m^3"});
    }
  }
  // The isentrope down to a hundredth of the C-J pressure, in even steps of the logarithm.
  Isentrope const isentrope(explosive.products, cj.density, cj.specific_energy);
  answer.profile = table_of({{"density", "kg/m^3"},
                             {"pressure", "Pa"},
                             {"velocity", "m/s"},
                             {"sound_speed", "m/s"},
                             {"specific_energy", "J/kg"}});
  for (double const part : even_steps(2.0, 0.0, values.points)) {
    IsentropeState const at = isentrope.at_pressure(cj.pressure * std::pow(10.0, -part));
    add_row(answer.profile, {at.density, at.pressure, cj.velocity - at.velocity_change,
                             at.sound_speed, at.specific_energy});
  }
  return answer;
}

ExactAnswer solve_taylor_wave(ExactValues const& values) {
  TaylorWave const wave(explosive_of(values));
  double const speed = wave.detonation().speed;
  double const t = values.has("time") ? values.number("time") : values.number("thickness") / speed;
  ExactAnswer answer{detonation_numbers(wave.detonation()),
                     flow_profile("x", even_steps(0.0, 1.1 * speed * t, values.points),
                                  [&](double x) { return wave.sample(x / t); })};
  for (ExactNumber const& number :
       {ExactNumber{"time", t, "s"}, ExactNumber{"position of the front", speed * t, "m"},
        ExactNumber{"pressure of the zone at rest", wave.rest().pressure, "Pa"},
        ExactNumber{"density of the zone at rest", wave.rest().density, "kg/m^3"},
        ExactNumber{"edge of the zone at rest", wave.rest_speed() * t, "m"},
        ExactNumber{"edge of the zone at rest / front", wave.rest_speed() / speed, ""}})
    answer.numbers.push_back(number);
  return answer;
}

ExactParameter time_parameter(std::string_view fallback, std::string_view meaning) {
  return exact_number("time", fallback, Quantity::time, ExactRange::positive, meaning);
}

void append(std::vector<ExactParameter>& parameters, std::vector<ExactParameter> const& more) {
  parameters.insert(parameters.end(), more.begin(), more.end());
}

ExactSolution riemann_solution() {
  std::vector<ExactParameter> parameters{exact_material("left", "tnt", "material at x < 0")};
  append(parameters,
         state_parameters({"left_density", "left_pressure", "left_energy", "left_velocity"},
                          "default: that of the material"));
  parameters.push_back(
      exact_material("right", "water_shock", "material at x > 0, or vacuum", {"vacuum"}));
  append(parameters,
         state_parameters({"right_density", "right_pressure", "right_energy", "right_velocity"},
                          "default: that of the material"));
  parameters.push_back(time_parameter("10 us", "time of the profile"));
  return {"riemann", "two materials that touch at x = 0: waves, contact, states between",
          menikoff_plohr, std::move(parameters), solve_riemann};
}

ExactSolution slab_solution() {
  std::vector<ExactParameter> parameters{
      exact_explosive("charge that has burnt in an instant"),
      exact_number("thickness", "10 cm", Quantity::length, ExactRange::positive,
                   "from the rigid wall x = 0 to the face"),
      exact_material("outside", "vacuum", "beyond the face: a material or vacuum", {"vacuum"})};
  append(parameters, state_parameters({"outside_density", "outside_pressure", "outside_energy",
                                       "outside_velocity"},
                                      "default: that of the material"));
  parameters.push_back(time_parameter("", "default: half of when the wave meets the wall"));
  return {"slab", "release of a slab of explosive that burnt in an instant, before a wall",
          menikoff_plohr, std::move(parameters), solve_slab};
}

}  // namespace

std::vector<ExactSolution> exact_material_solutions() {
  std::vector<ExactParameter> hugoniot{exact_material("material", "water_shock", "shocked")};
  append(hugoniot, state_parameters({"material_density", "material_pressure", "material_energy",
                                     "material_velocity"},
                                    "ahead; default: that of the material"));
  hugoniot.pop_back();  // at rest
  hugoniot.push_back(exact_number("fastest_piston", "2 km/s", Quantity::velocity,
                                  ExactRange::positive, "end of the curve"));
  ExactParameter const explosive = exact_explosive("a shipped material with eos jwl");
  return {
      riemann_solution(),
      {"hugoniot", "Rankine-Hugoniot curve: all shocks into a material at rest",
       "Zel'dovich and Raizer, Physics of Shock Waves (1966), chapter I, section 13",
       std::move(hugoniot), solve_hugoniot},
      {"cj",
       "Chapman-Jouguet state, isentrope of the products, and what they send on",
       "Fickett and Davis, Detonation (1979), chapter 2",
       {explosive, exact_material("into", "nothing", "what the front meets: a material or vacuum",
                                  {"nothing", "vacuum"})},
       solve_cj},
      {"taylor-wave",
       "plane detonation from a rigid wall x = 0 with its Taylor wave",
       "Taylor, Proc. R. Soc. Lond. A 200 (1950) 235",
       {explosive,
        exact_number("thickness", "10 cm", Quantity::length, ExactRange::positive,
                     "of the charge: decides the default time"),
        time_parameter("", "default: when the front has crossed the thickness")},
       solve_taylor_wave},
      slab_solution()};
}

}  // namespace moraine
