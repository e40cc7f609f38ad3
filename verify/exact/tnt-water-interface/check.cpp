// What TNT sends into water: a detonation that arrives, and products that have burnt in an instant.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "exact/detonation.hpp"
#include "exact/riemann.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/profile.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

constexpr double slab_thickness = 0.1;  // m, of the slab
// How the state at the interface is read, in smoothing lengths (README.md).
constexpr double shock_ahead = 10.0;
constexpr double read_from = 2.0, read_to = 5.0;

/// Halfway between the last particle of the slab and the first of the water [m].
double place_of_interface(Simulation const& simulation) {
  ParticleStore const& store = simulation.particles();
  auto const x = store.component(Field::position, 0);
  double slab = -std::numeric_limits<double>::infinity(), water = -slab;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (store.material()[i] == 0)
      slab = std::max(slab, x[i]);
    else
      water = std::min(water, x[i]);
  return 0.5 * (slab + water);
}

struct Transmitted {
  double pressure = 0.0;  // Pa, mean of both sides
  double velocity = 0.0;  // m/s
};

/// A field at the interface: the mean of its means on both sides, beyond the particles next to it.
double on_both_sides(Simulation const& simulation, Field field, double place, double h) {
  return 0.5 * (mean_between(simulation, field, place - read_to * h, place - read_from * h) +
                mean_between(simulation, field, place + read_from * h, place + read_to * h));
}

/// When the shock in the water, where the pressure is half of what it begins with, is ten
/// smoothing lengths ahead of the interface: a time after the arrival that is proportional to h.
Transmitted arrive(Case c, double spacing, double first_pressure) {
  c.numerics.spacing = spacing;
  c.time.end = 25e-6;  // not reached
  double const h = c.numerics.smoothing_length();
  Simulation simulation(build_model(c));
  while (simulation.running()) {
    simulation.advance();
    double const front = front_of_pressure(simulation, 0.5 * first_pressure);
    if (front < slab_thickness + shock_ahead * h) continue;  // not worth a look at the interface
    double const place = place_of_interface(simulation);
    if (front > place + shock_ahead * h)
      return {on_both_sides(simulation, Field::pressure, place, h),
              on_both_sides(simulation, Field::velocity, place, h)};
  }
  throw std::runtime_error("no shock in the water");
}

/// The limit of values at 4, 2 and 1 times a spacing whose error has a first and a second order.
double extrapolate(double at_4, double at_2, double at_1) {
  return (8.0 * at_1 - 6.0 * at_2 + at_4) / 3.0;
}

std::vector<CheckResult> detonation(Case const& c, RiemannProblem const& exact,
                                    std::vector<double> const& spacings) {
  std::vector<Transmitted> at;
  for (double const spacing : spacings) at.push_back(arrive(c, spacing, exact.star_pressure()));
  std::string const note =
      fmt::format("limit of {:.2f}, {:.2f}, {:.2f} GPa at {:g}, {:g}, {:g} mm",
                  1e-9 * at[0].pressure, 1e-9 * at[1].pressure, 1e-9 * at[2].pressure,
                  1e3 * spacings[0], 1e3 * spacings[1], 1e3 * spacings[2]);
  std::string const speeds = fmt::format("limit of {:.0f}, {:.0f}, {:.0f} m/s", at[0].velocity,
                                         at[1].velocity, at[2].velocity);
  double const p = exact.star_pressure(), u = exact.star_velocity();
  return {compare("tnt-water-interface: transmitted pressure",
                  1e-9 * extrapolate(at[0].pressure, at[1].pressure, at[2].pressure), 1e-9 * p,
                  0.05e-9 * p, "GPa", note),
          compare("tnt-water-interface: velocity of the interface",
                  extrapolate(at[0].velocity, at[1].velocity, at[2].velocity), u, 0.05 * u, "m/s",
                  speeds)};
}

std::vector<CheckResult> instantaneous(Case c, RiemannProblem const& exact, double spacing) {
  c.materials.front().burn.kind = BurnKind::instantaneous;
  c.numerics.spacing = spacing;
  c.time.end = 10e-6;  // the shock is 35 mm inside the water
  Simulation simulation(build_model(c));
  while (simulation.running()) simulation.advance();
  double const t = simulation.time();
  double const contact = slab_thickness + exact.star_velocity() * t;
  double const tail = slab_thickness + exact.left_wave().tail * t;
  double const shock = slab_thickness + exact.right_wave()->head * t;
  double const p = exact.star_pressure(), u = exact.star_velocity();
  std::string const at = fmt::format("{:g} mm, t = {:g} us", 1e3 * spacing, 1e6 * t);
  auto const middle = [&](Field field, double from, double to) {
    return mean_between(simulation, field, from + 0.2 * (to - from), to - 0.2 * (to - from));
  };
  return {compare("tnt-water-interface: plateau, products",
                  1e-9 * middle(Field::pressure, tail, contact), 1e-9 * p, 0.03e-9 * p, "GPa",
                  "burnt at once; " + at),
          compare("tnt-water-interface: plateau, water",
                  1e-9 * middle(Field::pressure, contact, shock), 1e-9 * p, 0.03e-9 * p, "GPa", at),
          compare("tnt-water-interface: way of the interface / time",
                  (place_of_interface(simulation) - slab_thickness) / t, u, 0.03 * u, "m/s", at)};
}

}  // namespace

std::vector<CheckResult> check_tnt_water_interface(Effort effort) {
  Case const c = shipped_case("tnt-water-slab");
  Jwl const tnt = std::get<Jwl>(c.materials[0].eos);
  WaterPolynomial const water = std::get<WaterPolynomial>(c.materials[1].eos);
  RiemannSide const at_rest{water, water.reference_density, 0.0,
                            c.regions[1].initial.specific_energy.value_or(water.reference_energy)};
  FlowState const cj = chapman_jouguet({tnt, tnt.reference_density, tnt.reference_energy}).behind;
  RiemannProblem const arrival({tnt, cj.density, cj.velocity, cj.specific_energy}, at_rest);
  RiemannProblem const burnt({tnt, tnt.reference_density, 0.0, tnt.reference_energy}, at_rest);
  double const finest = effort == Effort::full ? 0.025e-3 : 0.05e-3;
  auto results = detonation(c, arrival, {4.0 * finest, 2.0 * finest, finest});
  for (CheckResult& result : instantaneous(c, burnt, 0.1e-3)) results.push_back(std::move(result));
  return results;
}

}  // namespace moraine
