#include "verify/vortex_decay.hpp"

#include <cmath>
#include <variant>

#include "exact/taylor_green.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

TaylorGreen exact_of(Case const& c) {
  MaterialSpec const& liquid = c.materials.front();
  double const rho = reference_density(liquid.eos);
  return {c.domain.max[0] - c.domain.min[0], liquid.dynamic_viscosity / rho, 1.0, rho};
}

double velocity_error(Simulation const& simulation, TaylorGreen const& exact) {
  ParticleStore const& store = simulation.particles();
  double error2 = 0.0, size2 = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    auto const there = exact.sample(store.component(Field::position, 0)[i],
                                    store.component(Field::position, 1)[i], simulation.time());
    error2 += std::pow(store.component(Field::velocity, 0)[i] - there.velocity_x, 2) +
              std::pow(store.component(Field::velocity, 1)[i] - there.velocity_y, 2);
    size2 += there.velocity_x * there.velocity_x + there.velocity_y * there.velocity_y;
  }
  return std::sqrt(error2 / size2);
}

/// Densities whose pressure is that of the exact solution, above the background.
void set_pressure(Model& model, TaylorGreen const& exact) {
  ParticleStore& store = model.particles;
  auto const& law = std::get<Linear>(model.materials.front().eos);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    auto const there = exact.sample(store.component(Field::position, 0)[i],
                                    store.component(Field::position, 1)[i], 0.0);
    store.scalar(Field::density)[i] =
        law.density_at_pressure(law.background_pressure + there.pressure, law.reference_energy);
  }
}

}  // namespace

VortexRun run_vortices(Case c, std::vector<double> const& times) {
  TaylorGreen const exact = exact_of(c);
  c.time.end = times.back();
  Model model = build_model(c);
  set_pressure(model, exact);
  Simulation simulation(std::move(model));
  ConservedSums const before = simulation.sums();
  VortexRun run;
  while (simulation.running()) {
    simulation.advance();
    if (simulation.running() && simulation.time() < times[run.samples.size()]) continue;
    double const t = simulation.time();
    double const decay = std::log(before.kinetic_energy / simulation.sums().kinetic_energy);
    run.samples.push_back(
        {t, decay / (2.0 * exact.decay_rate() * t) - 1.0, velocity_error(simulation, exact)});
  }
  ConservedSums const after = simulation.sums();
  run.momentum = std::hypot(after.momentum[0], after.momentum[1]) / after.mass;
  run.energy_drift = (after.total_energy() - before.total_energy()) / before.kinetic_energy;
  run.steps = simulation.step();
  return run;
}

}  // namespace moraine
