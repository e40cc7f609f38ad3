// The sweep against the equations of docs/theory/sph.md, written out once more: all pairs, nearest
// images, plain sums, nothing shared with src/terms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "step/simulation_setup.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

/// The pair (i, j) of a model whose sides are all periodic.
struct PlainPair {
  PlainPair(Model const& model, std::size_t i, std::size_t j) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(model.dimension); ++axis) {
      auto const position = model.particles.component(Field::position, static_cast<int>(axis));
      auto const velocity = model.particles.component(Field::velocity, static_cast<int>(axis));
      double const period = model.domain_max[axis] - model.domain_min[axis];
      double const difference = position[i] - position[j];
      x[axis] = difference - period * std::round(difference / period);
      r2 += x[axis] * x[axis];
      v_x += (velocity[i] - velocity[j]) * x[axis];
    }
  }
  std::array<double, 3> x{};
  double r2 = 0.0;
  double v_x = 0.0;
};

/// (dW/dr) / r of the Wendland C2 kernel in two and three dimensions.
double gradient_factor(int dimension, double r, double h) {
  double const q = r / h;
  double const sigma =
      dimension == 2 ? 7.0 / (4.0 * std::numbers::pi) : 21.0 / (16.0 * std::numbers::pi);
  return -5.0 * sigma * std::pow(1.0 - 0.5 * q, 3) / std::pow(h, dimension + 2);
}

struct Rates {
  std::array<double, 3> acceleration{};
  double density = 0.0;
  double energy = 0.0;
};

Rates plain_rates(Model const& model, std::size_t i) {
  ParticleStore const& store = model.particles;
  Numerics const& n = model.numerics;
  bool const varies = n.smoothing.varies();
  auto const own = store.scalar(Field::smoothing_length);
  auto const rho = store.scalar(Field::density);
  auto const p = store.scalar(Field::pressure);
  auto const c = store.scalar(Field::sound_speed);
  double const c_0 = 100.0;  // of the first material
  Rates rates;
  for (std::size_t j = 0; j < store.size(); ++j) {
    PlainPair const pair(model, i, j);
    double const h = varies ? 0.5 * (own[i] + own[j]) : n.smoothing_length();
    if (j == i || pair.r2 >= 4.0 * h * h) continue;
    double const m = store.scalar(Field::mass)[j];
    double const gradient = gradient_factor(model.dimension, std::sqrt(pair.r2), h);
    double const softened = pair.r2 + 0.01 * h * h;
    double const mean_density = 0.5 * (rho[i] + rho[j]);
    double const mean_speed = 0.5 * (c[i] + c[j]);
    double const mu = pair.v_x < 0.0 ? h * pair.v_x / softened : 0.0;
    double const pressure = n.momentum == MomentumForm::mixed
                                ? (p[i] + p[j]) / (rho[i] * rho[j])
                                : p[i] / (rho[i] * rho[i]) + p[j] / (rho[j] * rho[j]);
    double const stress =
        pressure +
        (-n.viscosity_alpha * mean_speed * mu + n.viscosity_beta * mu * mu) / mean_density;
    for (std::size_t axis = 0; axis < 3; ++axis)
      rates.acceleration[axis] -= m * stress * gradient * pair.x[axis];
    rates.energy += 0.5 * m * stress * gradient * pair.v_x;
    double const share = n.continuity == ContinuityForm::volume ? rho[i] / rho[j] : 1.0;
    rates.density += share * m * pair.v_x * gradient;
    if (store.material()[i] != store.material()[j]) continue;
    double const rho_0 = store.material()[i] == 0 ? 1000.0 : 3000.0;
    double hydrostatic = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      hydrostatic += rho_0 * model.gravity[axis] * pair.x[axis] / (c_0 * c_0);
    rates.density += m / mean_density * 2.0 * n.density_diffusion * h * mean_speed *
                     (rho[i] - rho[j] - hydrostatic) * pair.r2 * gradient / softened;
  }
  return rates;
}

/// Two liquids with all terms, at pressures and sound speeds that no equation of state need allow.
Model two_liquids(int dimension, ContinuityForm continuity, MomentumForm momentum,
                  SchemeName scheme) {
  RandomBox box;
  box.dimension = dimension;
  box.scheme = scheme;
  box.side = dimension == 2 ? 16 : 8;
  Model model = random_box(box, 1.0);
  model.gravity = {3.0, -9.81, dimension == 3 ? 1.0 : 0.0};
  model.numerics.continuity = continuity;
  model.numerics.momentum = momentum;
  model.numerics.density_diffusion = 0.1;
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.size(); ++i) {
    store.scalar(Field::pressure)[i] = 1e5 * std::sin(1.7 * static_cast<double>(i));
    store.scalar(Field::sound_speed)[i] = 100.0 + 30.0 * std::cos(static_cast<double>(i));
  }
  return model;
}

TEST(PairEquations, AreWhatTheSweepSums) {
  for (int const dimension : {2, 3})
    for (ContinuityForm const continuity : {ContinuityForm::mass, ContinuityForm::volume})
      for (auto const& [flavour, momentum] :
           {std::pair{Flavour::reference, MomentumForm::conservative},
            std::pair{Flavour::full, MomentumForm::conservative},
            std::pair{Flavour::reference, MomentumForm::mixed},
            std::pair{Flavour::full, MomentumForm::mixed}})
        for (SchemeName const scheme : {SchemeName::compressible, SchemeName::variable}) {
          Model model = two_liquids(dimension, continuity, momentum, scheme);
          Search search(search_settings(model));
          search.refresh(model.particles);
          auto const pairs = make_pair_backend(dimension, flavour, scheme, sweep_parameters(model),
                                               reference_densities(model));
          pairs->gather_fluid(model.particles, search, 0.0);
          pairs->sweep(model.particles, search);
          // Sums of some ten to sixty terms in another order; measured 2.3e-15.
          ParticleStore const& store = model.particles;
          double worst = 0.0;
          auto const compare = [&](Field field, int axis, std::size_t i, double expected) {
            worst = std::max(worst, std::fabs(store.component(field, axis)[i] - expected) /
                                        largest(store, field, axis));
          };
          for (std::size_t i = 0; i < store.size(); ++i) {
            Rates const rates = plain_rates(model, i);
            for (int axis = 0; axis < dimension; ++axis)
              compare(Field::acceleration, axis, i,
                      rates.acceleration[static_cast<std::size_t>(axis)]);
            compare(Field::density_rate, 0, i, rates.density);
            compare(Field::energy_rate, 0, i, rates.energy);
          }
          EXPECT_LE(worst, 1e-14);
        }
}

}  // namespace
}  // namespace moraine
