#include "verify/l1_errors.hpp"

#include <fmt/core.h>

#include <cmath>

#include "setup/build_model.hpp"

namespace moraine {
namespace {

struct Along {
  double coordinate;  // m
  double velocity;    // m/s
};

Along along(ParticleStore const& store, std::size_t i, FlowCoordinate coordinate) {
  double const x = store.component(Field::position, 0)[i];
  if (coordinate == FlowCoordinate::x) return {x, store.component(Field::velocity, 0)[i]};
  double square = 0.0, product = 0.0;
  for (int axis = 0; axis < store.dimension(); ++axis) {
    double const place = store.component(Field::position, axis)[i];
    square += place * place;
    product += place * store.component(Field::velocity, axis)[i];
  }
  double const r = std::sqrt(square);
  return {r, product / r};
}

}  // namespace

L1Errors l1_errors(Simulation const& simulation, FlowCoordinate coordinate,
                   ExactFlow const& exact) {
  ParticleStore const& store = simulation.particles();
  auto const rho = store.scalar(Field::density);
  auto const p = store.scalar(Field::pressure);
  auto const mass = store.scalar(Field::mass);
  L1Errors error, size;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    Along const own = along(store, i, coordinate);
    std::optional<FlowState> const state = exact(own.coordinate);
    if (!state) continue;
    double const volume = mass[i] / rho[i];
    error.density += volume * std::fabs(rho[i] - state->density);
    error.velocity += mass[i] * std::fabs(own.velocity - state->velocity);
    error.pressure += volume * std::fabs(p[i] - state->pressure);
    size.density += volume * state->density;
    size.velocity += mass[i] * std::fabs(state->velocity);
    size.pressure += volume * state->pressure;
  }
  return {error.density / size.density, error.velocity / size.velocity,
          error.pressure / size.pressure};
}

std::string in_words(SpacingPair const& spacings) {
  return fmt::format("at {:g} and {:g} mm", 1e3 * spacings.coarse, 1e3 * spacings.fine);
}

double convergence_order(double coarse_error, double fine_error, double ratio) {
  return std::log(coarse_error / fine_error) / std::log(ratio);
}

double first_order_limit(double coarse, double fine, double ratio) {
  return fine + (fine - coarse) / (ratio - 1.0);
}

Simulation run_to_end(Case const& c) {
  Simulation simulation(build_model(c));
  while (simulation.running()) simulation.advance();
  return simulation;
}

}  // namespace moraine
