// Momentum of closed, disordered systems.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "step/simulation.hpp"
#include "verify/random_box.hpp"

namespace moraine {
namespace {

/// Sum over particles of mass times the length of the acceleration [N].
double sum_of_forces(Simulation const& simulation) {
  ParticleStore const& store = simulation.particles();
  double sum = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double a2 = 0.0;
    for (int axis = 0; axis < store.dimension(); ++axis)
      a2 += std::pow(store.component(Field::acceleration, axis)[i], 2);
    sum += store.scalar(Field::mass)[i] * std::sqrt(a2);
  }
  return sum;
}

/// Change of momentum in 50 steps, divided by the impulse that the particles exchanged:
///   |P(t) - P(0)| / sum over steps and particles of m |dv/dt| dt.
double lost_share(RandomBox const& box) {
  Simulation simulation(random_box(box, 1.0));
  auto const before = simulation.sums().momentum;
  double exchanged = 0.0;
  for (int step = 0; step < 50; ++step) {
    simulation.advance();
    exchanged += sum_of_forces(simulation) * simulation.time_step();
  }
  auto const after = simulation.sums().momentum;
  double change2 = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    change2 += (after[axis] - before[axis]) * (after[axis] - before[axis]);
  return std::sqrt(change2) / exchanged;
}

std::vector<CheckResult> check_momentum(Precision precision, double limit, char const* name) {
  std::vector<CheckResult> results;
  for (int const dimension : {2, 3})
    for (SchemeName const scheme : {SchemeName::compressible, SchemeName::liquid}) {
      RandomBox box;
      box.dimension = dimension;
      box.side = dimension == 2 ? 64 : 16;
      box.scheme = scheme;
      box.precision = precision;
      char const* const what = scheme == SchemeName::liquid ? "one liquid" : "two liquids";
      results.push_back(at_most(fmt::format("{}: {}D, {}", name, dimension, what), lost_share(box),
                                limit, "-",
                                "change / impulse exchanged, 4096 particles, 50 steps"));
    }
  return results;
}

}  // namespace

std::vector<CheckResult> check_momentum_double(Effort) {
  return check_momentum(Precision::full, 1e-14, "momentum-double");
}

std::vector<CheckResult> check_momentum_mixed(Effort) {
  return check_momentum(Precision::mixed, 1e-6, "momentum-mixed");
}

}  // namespace moraine
