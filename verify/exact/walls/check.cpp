// Walls that mirror the fluid, push it, or both: rest, reflection, leaks.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "setup/build_model.hpp"
#include "setup/mirror_walls.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

constexpr double g = 9.81;      // m/s^2
constexpr double rho_0 = 1000;  // kg/m^3
constexpr double depth = 0.5;   // m

struct Method {
  WallMethod method;
  char const* name;
};

/// The shipped tank of still water between walls of a method.
Case still_tank(WallMethod method, Slip slip, double spacing, double end) {
  Case tank = shipped_case("hydrostatic-tank");
  tank.numerics.spacing = spacing;
  tank.time.end = end;
  tank.walls[0].method = method;
  tank.walls[0].slip = slip;
  if (tank.walls[0].pushes()) tank.walls[0].repulsion = 5.0 * g * depth;
  end_domain_at_mirrors(tank);
  return tank;
}

/// The largest error of the pressure of any particle at the end, over rho g H. The law of Tait
/// bends the profile by rho g H^2 / (2 c^2), which is counted.
double profile_error(Simulation const& simulation) {
  ParticleStore const& store = simulation.particles();
  Tait const water = std::get<Tait>(simulation.model().materials.front().eos);
  double const c2 = std::pow(water.reference_sound_speed, 2);
  double const n = water.exponent - 1.0;
  double const bottom = std::pow(water.density_at_pressure(rho_0 * g * depth, 0.0) / rho_0, n);
  double worst = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const z = store.component(Field::position, 1)[i];
    double const ratio = std::pow(std::max(bottom - n * g * z / c2, 0.0), 1.0 / n);
    double const exact = water.pressure(ratio * rho_0, 0.0);
    worst = std::max(worst, std::fabs(store.scalar(Field::pressure)[i] - exact));
  }
  return worst / (rho_0 * g * depth);
}

CheckResult still_water(Method const& method, Slip slip, Effort effort) {
  double const end = effort == Effort::quick ? 0.03 : 0.1;
  Simulation simulation(build_model(still_tank(method.method, slip, 0.0078125, end)));
  while (simulation.running()) simulation.advance();
  return at_most(fmt::format("walls: still water, {}, {}", method.name,
                             slip == Slip::free ? "free slip" : "no slip"),
                 profile_error(simulation), 0.01, "-",
                 fmt::format("largest error / rho g H of any particle after {:g} s", end));
}

/// A pulse of sound, p = A exp(-((x - x_0) / w)^2), that runs along a closed channel of water to
/// the mirror at x = 0 and back: d'Alembert's solution, in which the pressure at the wall is twice
/// that of the pulse, and the pulse comes back with its sign.
struct Pulse {
  static constexpr double sound = 100.0, amplitude = 100.0, width = 0.1, start = 0.5;

  static Model model(double spacing) {
    Case c;
    c.dimension = 1;
    c.numerics.spacing = spacing;
    c.numerics.smoothing_factor = 2.0;  // sound on the lattice is 0.6 % slow; 2 % at 1.2
    c.numerics.precision = Precision::full;
    c.numerics.viscosity_alpha = 0.0;
    c.numerics.viscosity_beta = 0.0;
    c.domain = {{-1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
    Tait water;
    water.reference_sound_speed = sound;
    c.materials = {{"water", water}};
    c.regions = {{"water", "water", Box{{}, {2.0, 0.0, 0.0}}, {}}};
    WallSpec wall;
    wall.name = "channel";
    wall.box = {{}, {2.0, 0.0, 0.0}};
    wall.method = WallMethod::mirror;
    c.walls = {wall};
    c.time.end = 2.0 * start / sound;
    end_domain_at_mirrors(c);
    Model model = build_model(c);
    ParticleStore& store = model.particles;
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
      double const x = store.component(Field::position, 0)[i];
      double const p = amplitude * std::exp(-std::pow((x - start) / width, 2));
      store.scalar(Field::density)[i] = water.density_at_pressure(p, 0.0);
      store.component(Field::velocity, 0)[i] = -p / (rho_0 * sound);
    }
    return model;
  }
};

std::vector<CheckResult> pulse_of_sound() {
  Simulation simulation(Pulse::model(0.0025));
  ParticleStore const& store = simulation.particles();
  auto const pressure = store.scalar(Field::pressure);
  double at_wall = 0.0;
  while (simulation.running()) {
    simulation.advance();
    std::size_t first = 0;
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
      if (store.component(Field::position, 0)[i] < store.component(Field::position, 0)[first])
        first = i;
    at_wall = std::max(at_wall, store.scalar(Field::pressure)[first]);
  }
  double back = 0.0, place = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (store.scalar(Field::pressure)[i] > back) {
      back = store.scalar(Field::pressure)[i];
      place = store.component(Field::position, 0)[i];
    }
  return {compare("walls: pressure of a pulse at a mirror", at_wall / Pulse::amplitude, 2.0, 0.01,
                  "-", "largest pressure of the first particle over that of the pulse"),
          compare("walls: pulse that comes back", back / Pulse::amplitude, 1.0, 0.01, "-",
                  "largest pressure over that at the start"),
          compare("walls: place of the pulse that comes back", place, Pulse::start, 0.01, "m",
                  "of its peak; a tenth of its width")};
}

/// Particles that stand outside of the tank or were lost.
double outside(Simulation const& simulation, Box const& tank) {
  ParticleStore const& store = simulation.particles();
  auto count = static_cast<double>(simulation.lost().count);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    bool inside = true;
    for (int axis = 0; axis < 2; ++axis) {
      auto const k = static_cast<std::size_t>(axis);
      double const x = store.component(Field::position, axis)[i];
      inside = inside && x >= tank.min[k] && x <= tank.max[k];
    }
    if (!inside) count += 1.0;
  }
  return count;
}

/// Water that falls over in a closed tank: how much energy came from nowhere, and how many
/// particles stand outside of it after many steps. Mirrors put every particle back in each step:
/// only walls that push can leak.
std::vector<CheckResult> collapse(Method const& method, Effort effort) {
  Case c = shipped_case("dam-break-2d");
  c.numerics.spacing = 0.1 * 0.05715;  // the column is ten particles wide
  c.time.end = 1e9;
  c.walls[0].method = method.method;
  c.walls[0].open = {};
  if (c.walls[0].pushes()) c.walls[0].repulsion = 5.0 * g * 0.1143;
  end_domain_at_mirrors(c);
  Simulation simulation(build_model(c));
  ConservedSums const before = simulation.sums();
  int const steps = effort == Effort::quick ? 2000 : 20000;
  double largest = 0.0;
  for (int step = 0; step < steps; ++step) {
    simulation.advance();
    if (step % 100 == 0) largest = std::max(largest, simulation.sums().kinetic_energy);
  }
  double const drift =
      simulation.sums().total_energy() + simulation.lost().energy - before.total_energy();
  std::vector<CheckResult> results{at_most(fmt::format("walls: energy, {}", method.name),
                                           drift / largest, 0.01, "-",
                                           "energy gained over the largest kinetic energy")};
  if (method.method == WallMethod::repulsive)
    results.push_back(at_most(
        fmt::format("walls: leaks, {}", method.name), outside(simulation, c.walls[0].box), 0.0, "-",
        fmt::format("particles of {} outside of the tank after {} steps",
                    simulation.particles().range(Kind::fluid).size(), steps)));
  return results;
}

}  // namespace

std::vector<CheckResult> check_walls(Effort effort) {
  Method const mirror{WallMethod::mirror, "mirror"};
  Method const both{WallMethod::mirror_and_repulsive, "mirror and repulsive"};
  Method const repulsive{WallMethod::repulsive, "repulsive"};
  std::vector<CheckResult> results{still_water(mirror, Slip::free, effort),
                                   still_water(mirror, Slip::none, effort),
                                   still_water(both, Slip::free, effort)};
  auto const add = [&](std::vector<CheckResult> const& more) {
    results.insert(results.end(), more.begin(), more.end());
  };
  add(pulse_of_sound());
  for (Method const& method : {mirror, both, repulsive}) add(collapse(method, effort));
  return results;
}

}  // namespace moraine
