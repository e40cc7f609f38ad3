// Exact solutions for an ideal gas: shock tubes, Noh, Sedov.
#include <fmt/core.h>

#include <array>

#include "app/exact_profile.hpp"
#include "app/exact_solution.hpp"
#include "exact/noh.hpp"
#include "exact/riemann.hpp"
#include "exact/sedov.hpp"
#include "exact/shock_tubes.hpp"

namespace moraine {
namespace {

constexpr double gamma_of_tubes = 1.4;

ExactAnswer solve_tube(ShockTube const& tube, ExactValues const& values) {
  double const t = values.number("time");
  auto const side = [](GasState const& gas) -> RiemannSide {
    IdealGas law;
    law.heat_capacity_ratio = gamma_of_tubes;
    return {law, gas.density, gas.velocity, law.energy_at_pressure(gas.density, gas.pressure)};
  };
  RiemannProblem const solution(side(tube.left), side(tube.right));
  return {riemann_numbers(solution, t, tube.membrane),
          flow_profile("x", even_steps(0.0, 1.0, values.points),
                       [&](double x) { return solution.sample((x - tube.membrane) / t); })};
}

ExactSolution tube_solution(ShockTube const& tube, std::string_view time) {
  return {std::string(tube.name),
          fmt::format("shock tube from 0 to 1 m, gamma 1.4: {}", tube.meaning),
          tube.name == "sod" ? "Sod, J. Comput. Phys. 27 (1978) 1"
                             : "Toro, Riemann Solvers, 3rd ed. (2009), table 4.1",
          {exact_number("time", time, Quantity::time, ExactRange::positive, "time")},
          [tube](ExactValues const& values) { return solve_tube(tube, values); }};
}

ExactParameter geometry_parameter() {
  return exact_choice("geometry", {"planar", "cylindrical", "spherical"}, "spherical",
                      "what the coordinate r is");
}

FlowGeometry geometry_of(ExactValues const& values) {
  std::string const& text = values.text("geometry");
  if (text == "planar") return FlowGeometry::planar;
  return text == "cylindrical" ? FlowGeometry::cylindrical : FlowGeometry::spherical;
}

ExactParameter gamma_parameter(std::string_view fallback) {
  return exact_number("heat_capacity_ratio", fallback, Quantity::number, ExactRange::positive,
                      "gamma of the gas, above 1");
}

ExactAnswer solve_noh(ExactValues const& values) {
  Noh const noh{geometry_of(values), values.number("heat_capacity_ratio"), values.number("density"),
                values.number("speed")};
  noh.check();
  double const t = values.number("time"), shock = noh.shock_position(t);
  FlowState const inside = noh.sample(0.0, t);
  return {{{"shock position", shock, "m"},
           {"shock speed", shock / t, "m/s"},
           {"density behind the shock", inside.density, "kg/m^3"},
           {"pressure behind the shock", inside.pressure, "Pa"},
           {"specific energy behind the shock", inside.specific_energy, "J/kg"}},
          flow_profile("r", even_steps(0.0, 4.0 * shock, values.points),
                       [&](double r) { return noh.sample(r, t); })};
}

ExactAnswer solve_sedov(ExactValues const& values) {
  Sedov const sedov({geometry_of(values), values.number("heat_capacity_ratio"),
                     values.number("density"), values.number("energy")});
  double const t = values.number("time"), shock = sedov.shock_position(t);
  FlowState const behind = sedov.behind_shock(t);
  // In the origin itself the specific energy is infinite.
  double const first = 1.2 * shock / values.points;
  return {{{"alpha", sedov.alpha(), ""},
           {"shock position", shock, "m"},
           {"shock speed", sedov.shock_speed(t), "m/s"},
           {"density behind the shock", behind.density, "kg/m^3"},
           {"velocity behind the shock", behind.velocity, "m/s"},
           {"pressure behind the shock", behind.pressure, "Pa"},
           {"pressure in the origin", sedov.sample(0.0, t).pressure, "Pa"}},
          flow_profile("r", even_steps(first, 1.2 * shock, values.points),
                       [&](double r) { return sedov.sample(r, t); })};
}

}  // namespace

std::vector<ExactSolution> exact_gas_solutions() {
  // In the order of shock_tubes, whose times these are.
  constexpr std::array<std::string_view, 6> times{"0.2 s",   "0.25 s",  "0.15 s",
                                                  "0.012 s", "0.035 s", "0.035 s"};
  std::vector<ExactSolution> solutions;
  for (std::size_t k = 0; k < shock_tubes.size(); ++k)
    solutions.push_back(tube_solution(shock_tubes[k], times[k]));
  ExactParameter const density = exact_number("density", "1 kg/m^3", Quantity::density,
                                              ExactRange::positive, "of the gas ahead");
  solutions.push_back(
      {"noh",
       "cold gas that streams to a plane, an axis or a centre and is stopped by a shock",
       "Noh, J. Comput. Phys. 72 (1987) 78",
       {geometry_parameter(), gamma_parameter("1.6666666666666667"), density,
        exact_number("speed", "1 m/s", Quantity::velocity, ExactRange::positive,
                     "towards the origin"),
        exact_number("time", "0.6 s", Quantity::time, ExactRange::positive, "time")},
       solve_noh});
  solutions.push_back(
      {"sedov",
       "strong blast wave from a plane, a line or a point",
       "Kamm and Timmes, LA-UR-07-2849 (2007); Sedov, Similarity and Dimensional Methods (1959)",
       {geometry_parameter(), gamma_parameter("1.4"), density,
        exact_number("energy", "0.851072", Quantity::number, ExactRange::positive,
                     "released: J; cylindrical J/m; planar J/m^2 for each side of the plane"),
        exact_number("time", "1 s", Quantity::time, ExactRange::positive, "time")},
       solve_sedov});
  return solutions;
}

}  // namespace moraine
