// Viscous flow between two plates against its series solution.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "exact/channel_flow.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

constexpr double width = 0.01;                           // m, of the gap
constexpr std::array sample_times{0.05, 0.1, 0.2, 0.5};  // width^2 / nu

/// One of the two flows: the name of its shipped case, and its velocity [m/s] at y [m] and t [s].
struct Flow {
  std::string name;
  Case c;
  double viscosity;  // m^2/s
  std::function<double(double, double)> velocity;
};

/// Errors at all sample times.
struct Errors {
  double worst = 0.0;     // relative L2 error of the velocities, the largest of all times
  double at = 0.0;        // width^2 / nu, when
  double mean = 0.0;      // root of the mean square of the four
  double largest = 0.0;   // of any particle, by the largest velocity of that time
  double unbooked = 0.0;  // energy gained less work of the walls, by that work
};

/// The case with `rows` rows of particles, in a period of ten.
Case with_rows(Case c, int rows) {
  double const spacing = width / rows;
  double const period = 10.0 * spacing;
  c.numerics.spacing = spacing;
  c.domain.max[0] = period;
  std::get<Box>(c.regions.front().shape).max[0] = period;
  for (WallSpec& wall : c.walls) wall.box.max[0] = period;
  return c;
}

void add_sample(Simulation const& simulation, Flow const& flow, Errors& errors) {
  ParticleStore const& store = simulation.particles();
  auto const y = store.component(Field::position, 1);
  auto const u = store.component(Field::velocity, 0);
  double error2 = 0.0, size2 = 0.0, worst = 0.0, fastest = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const exact = flow.velocity(y[i], simulation.time());
    error2 += (u[i] - exact) * (u[i] - exact);
    size2 += exact * exact;
    worst = std::max(worst, std::fabs(u[i] - exact));
    fastest = std::max(fastest, exact);
  }
  double const error = std::sqrt(error2 / size2);
  errors.mean = std::sqrt(errors.mean * errors.mean + error * error / sample_times.size());
  errors.largest = std::max(errors.largest, worst / fastest);
  if (error <= errors.worst) return;
  errors.worst = error;
  errors.at = simulation.time() * flow.viscosity / (width * width);
}

Errors run(Flow const& flow, int rows) {
  Case c = with_rows(flow.c, rows);
  double const unit = width * width / flow.viscosity;
  c.time.end = sample_times.back() * unit;
  Simulation simulation(build_model(c));
  double const energy = simulation.sums().total_energy();
  Errors errors;
  std::size_t sampled = 0;
  while (simulation.running()) {
    simulation.advance();
    if (simulation.running() && simulation.time() < sample_times[sampled] * unit) continue;
    ++sampled;
    add_sample(simulation, flow, errors);
  }
  double const work = simulation.booked().walls;
  errors.unbooked = (simulation.sums().total_energy() - energy - work) / work;
  return errors;
}

/// Both flows as shipped.
std::vector<Flow> flows() {
  std::vector<Flow> both;
  for (char const* name : {"poiseuille", "couette"}) {
    Case const c = shipped_case(name);
    MaterialSpec const& glycerol = c.materials.front();
    double const nu = glycerol.dynamic_viscosity / reference_density(glycerol.eos);
    both.push_back({name, c, nu, {}});
    PoiseuilleFlow const falling{width, nu, c.gravity[0]};
    CouetteFlow const sheared{width, nu, 0.1};  // m/s, of the plate in the case
    if (c.walls.size() == 1)
      both.back().velocity = [=](double y, double t) { return falling.velocity(y, t); };
    else
      both.back().velocity = [=](double y, double t) { return sheared.velocity(y, t); };
  }
  return both;
}

void add_morris(Flow const& flow, int rows, std::vector<CheckResult>& results) {
  Errors const coarse = run(flow, rows / 2);
  Errors const fine = run(flow, rows);
  std::string const name = "viscous-flow: " + flow.name;
  results.push_back(at_most(name + ", velocity", fine.worst, 0.01, "-",
                            fmt::format("L2, {} rows, the largest at four times, at {:.2f} L^2/nu; "
                                        "any particle {:.2g}",
                                        rows, fine.at, fine.largest)));
  results.push_back(compare(name + ", order", std::log2(coarse.mean / fine.mean), 2.0, 0.5, "-",
                            fmt::format("L2 errors {:.3g}, {:.3g} with {} and {} rows", coarse.mean,
                                        fine.mean, rows / 2, rows)));
  if (flow.c.walls.size() == 2)
    results.push_back(at_most(name + ", energy", fine.unbooked, 1e-3, "-",
                              "energy gained less work of the plates / work"));
}

void add_central(Flow flow, int rows, std::vector<CheckResult>& results) {
  flow.c.numerics.physical_viscosity = ViscosityForm::monaghan_cleary;
  flow.c.numerics.smoothing_factor = 2.5;  // README.md
  Errors const errors = run(flow, rows);
  results.push_back(
      at_most("viscous-flow: " + flow.name + ", monaghan_cleary", errors.worst, 0.01, "-",
              fmt::format("L2, {} rows, h of 2.5 spacings, the largest at four times, "
                          "at {:.2f} L^2/nu; any particle {:.2g}",
                          rows, errors.at, errors.largest)));
}

}  // namespace

std::vector<CheckResult> check_viscous_flow(Effort effort) {
  int const rows = effort == Effort::full ? 40 : 24;
  std::vector<CheckResult> results;
  for (Flow const& flow : flows()) {
    add_morris(flow, rows, results);
    add_central(flow, rows, results);
  }
  return results;
}

}  // namespace moraine
