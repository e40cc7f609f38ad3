// Drift of the total energy of a closed system against the time step.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <vector>

#include "step/simulation.hpp"
#include "verify/random_box.hpp"

namespace moraine {
namespace {

/// |E(t) - E(0)| / kinetic energy at the start, after 1.6 ms in steps of `step` [s].
double drift(RandomBox const& box, double step) {
  Model model = random_box(box, 1.6e-3);
  model.time.fixed_step = step;
  Simulation simulation(std::move(model));
  ConservedSums const before = simulation.sums();
  while (simulation.running()) simulation.advance();
  return std::fabs(simulation.sums().total_energy() - before.total_energy()) /
         before.kinetic_energy;
}

}  // namespace

std::vector<CheckResult> check_energy_order(Effort) {
  std::vector<CheckResult> results;
  for (int const dimension : {2, 3}) {
    RandomBox box;
    box.dimension = dimension;
    box.side = dimension == 2 ? 32 : 12;
    std::array<double, 3> drifts;
    for (std::size_t k = 0; k < 3; ++k)
      drifts[k] = drift(box, std::ldexp(8e-6, -static_cast<int>(k)));
    results.push_back(compare(fmt::format("energy-order: {}D", dimension),
                              std::log2(drifts[1] / drifts[2]), 2.0, 0.2, "-",
                              fmt::format("drift / kinetic energy {:.3g}, {:.3g}, {:.3g} at 8, 4, "
                                          "2 us",
                                          drifts[0], drifts[1], drifts[2])));
  }
  return results;
}

}  // namespace moraine
