// Each optional term against its formula, written plainly over all pairs of a disordered box.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>

#include "base/vec3.hpp"
#include "support/option_reference.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

/// What an option adds to one particle.
struct Rates {
  std::array<double, 3> acceleration{}, drift{};
  double density_rate = 0.0;
  double energy_rate = 0.0;
};

struct Option {
  char const* name;
  void (*choose)(Numerics&);
  Rates (*plain)(Model const&, std::size_t);
};

double rho(Model const& m, std::size_t i) { return m.particles.scalar(Field::density)[i]; }
double mass(Model const& m, std::size_t i) { return m.particles.scalar(Field::mass)[i]; }
double speed(Model const& m, std::size_t i, std::size_t a) {
  return m.particles.component(Field::velocity, static_cast<int>(a))[i];
}
double viscosity_of(Model const& m, std::size_t i) {
  return m.materials[m.particles.material()[i]].dynamic_viscosity;
}
std::size_t axes(Model const& m) { return static_cast<std::size_t>(m.dimension); }
double square(PlainPair const& p) { return p.x[0] * p.x[0] + p.x[1] * p.x[1] + p.x[2] * p.x[2]; }

Rates plain_morris(Model const& m, std::size_t i) {
  Rates rates;
  for (PlainPair const& p : plain_pairs(m, i)) {
    double const factor = mass(m, p.j) * (viscosity_of(m, i) + viscosity_of(m, p.j)) /
                          (rho(m, i) * rho(m, p.j)) * p.gradient;
    for (std::size_t a = 0; a < axes(m); ++a) {
      double const v = speed(m, i, a) - speed(m, p.j, a);
      rates.acceleration[a] += factor * v;
      rates.energy_rate -= 0.5 * factor * v * v;
    }
  }
  return rates;
}

Rates plain_cleary(Model const& m, std::size_t i) {
  Rates rates;
  for (PlainPair const& p : plain_pairs(m, i)) {
    double const mu_i = viscosity_of(m, i), mu_j = viscosity_of(m, p.j);
    double const approach = plain_approach(m, i, p);
    double const pi = 2.0 * (m.dimension + 2) / (rho(m, i) * rho(m, p.j)) * 2.0 * mu_i * mu_j /
                      (mu_i + mu_j) * approach / square(p);
    for (std::size_t a = 0; a < axes(m); ++a)
      rates.acceleration[a] += mass(m, p.j) * pi * p.gradient * p.x[a];
    rates.energy_rate -= 0.5 * mass(m, p.j) * pi * p.gradient * approach;
  }
  return rates;
}

Rates plain_xsph(Model const& m, std::size_t i) {
  Rates rates;
  for (PlainPair const& p : plain_pairs(m, i))
    for (std::size_t a = 0; a < axes(m); ++a)
      rates.drift[a] += 0.5 * mass(m, p.j) / (0.5 * (rho(m, i) + rho(m, p.j))) *
                        (speed(m, p.j, a) - speed(m, i, a)) * p.kernel;
  return rates;
}

Rates plain_penalty(Model const& m, std::size_t i) {
  Rates rates;
  double const lambda = m.numerics.spacing / m.numerics.smoothing_length();
  for (PlainPair const& p : plain_pairs(m, i)) {
    if (m.particles.material()[i] == m.particles.material()[p.j]) continue;
    double const r = std::sqrt(square(p));
    double const pe = lambda * (plain_smoothing(m, i) + plain_smoothing(m, p.j)) / (2.0 * r);
    if (pe <= 1.0) continue;
    double const f = 2e3 * (std::pow(pe, 12) - std::pow(pe, 6)) / (r * r);
    for (std::size_t a = 0; a < axes(m); ++a) rates.acceleration[a] += f * p.x[a] / mass(m, i);
  }
  return rates;
}

/// s (M^-1 - 1), with s from 1 to 0 while sqrt(d) / |M^-1| falls from 0.4 to 0.2.
Matrix plain_correction_of(Model const& m, std::size_t i, bool of_one_material) {
  Matrix k = inverse(plain_moments(m, i, of_one_material), m.dimension);
  double norm2 = 0.0;
  for (auto const& row : k)
    for (double const entry : row) norm2 += entry * entry;
  double const share = std::clamp((std::sqrt(m.dimension / norm2) - 0.2) / 0.2, 0.0, 1.0);
  for (std::size_t a = 0; a < axes(m); ++a)
    for (std::size_t b = 0; b < axes(m); ++b) k[a][b] = share * (k[a][b] - (a == b ? 1.0 : 0.0));
  return k;
}

std::array<double, 3> plain_gradient(Model const& m, std::size_t i) {
  std::array<double, 3> slope{};
  for (PlainPair const& p : plain_pairs(m, i)) {
    if (m.particles.material()[i] != m.particles.material()[p.j]) continue;
    for (std::size_t a = 0; a < axes(m); ++a)
      slope[a] += mass(m, p.j) / rho(m, p.j) * (rho(m, p.j) - rho(m, i)) * p.gradient * p.x[a];
  }
  Matrix const k = plain_correction_of(m, i, true);
  std::array<double, 3> gradient = slope;
  for (std::size_t a = 0; a < axes(m); ++a)
    for (std::size_t b = 0; b < axes(m); ++b) gradient[a] += k[a][b] * slope[b];
  return gradient;
}

Rates plain_diffusion(Model const& m, std::size_t i) {
  Rates rates;
  auto const own = plain_gradient(m, i);
  auto const c = m.particles.scalar(Field::sound_speed);
  for (PlainPair const& p : plain_pairs(m, i)) {
    if (m.particles.material()[i] != m.particles.material()[p.j]) continue;
    auto const other = plain_gradient(m, p.j);
    double along = 0.0;
    for (std::size_t a = 0; a < axes(m); ++a) along += (own[a] + other[a]) * p.x[a] * p.gradient;
    rates.density_rate -= 0.1 * 0.5 * (c[i] + c[p.j]) * p.h * mass(m, p.j) /
                          (0.5 * (rho(m, i) + rho(m, p.j))) * along;
  }
  return rates;
}

/// v_ij, that of walls at rest.
std::array<double, 3> velocity_of(Model const& m, std::size_t i, PlainPair const& p) {
  std::array<double, 3> v{};
  for (std::size_t a = 0; a < axes(m); ++a)
    v[a] = speed(m, i, a) - (p.wall ? 0.0 : speed(m, p.j, a));
  return v;
}

/// v as the continuity equation sees it: with free slip along the normal of the wall particle
/// alone, where it has one.
std::array<double, 3> seen_of(Model const& m, PlainPair const& p, std::array<double, 3> const& v) {
  if (!p.wall) return v;
  WallPoint const& point = m.walls.points[m.particles.id()[p.j] - m.walls.first_id];
  Vec3 const n = m.walls.normal(point);
  if (!point.free_slip || norm(n) == 0.0) return v;
  Vec3 const along = scale(dot({v[0], v[1], v[2]}, n), n);
  return {along[0], along[1], along[2]};
}

/// What stands before K_i grad W and K_j grad W: in the conservative form p / rho^2 of each, in the
/// mixed form p / (rho_i rho_j). A wall has K_j = 0, and a pressure that never pulls with that of
/// i.
std::array<double, 2> pressures_of(Model const& m, std::size_t i, PlainPair const& p) {
  auto const pressure = m.particles.scalar(Field::pressure);
  bool const mixed = m.numerics.momentum == MomentumForm::mixed;
  double const p_i = pressure[i] / rho(m, i) / rho(m, mixed ? p.j : i);
  double const p_j = pressure[p.j] / rho(m, p.j) / rho(m, mixed ? i : p.j);
  if (p.wall) return {std::max(p_i + p_j, 0.0), 0.0};
  return {p_i, p_j};
}

std::array<double, 3> turned(Matrix const& k, PlainPair const& p) {
  std::array<double, 3> turned{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) turned[a] += k[a][b] * p.x[b] * p.gradient;
  return turned;
}

Rates plain_correction(Model const& m, std::size_t i) {
  Rates rates;
  bool const volume = m.numerics.continuity == ContinuityForm::volume;
  Matrix const k_i = plain_correction_of(m, i, false);
  for (PlainPair const& p : plain_pairs(m, i)) {
    auto const own = turned(k_i, p);
    auto const other = turned(p.wall ? Matrix{} : plain_correction_of(m, p.j, false), p);
    auto const [p_i, p_j] = pressures_of(m, i, p);
    auto const v = velocity_of(m, i, p);
    auto const seen = seen_of(m, p, v);
    double const weight =
        p.wall ? rho(m, p.j) * std::pow(m.numerics.spacing, m.dimension) : mass(m, p.j);
    for (std::size_t a = 0; a < axes(m); ++a) {
      double const push = p_i * own[a] + p_j * other[a];
      rates.acceleration[a] -= weight * push;
      rates.density_rate += weight * (volume ? rho(m, i) / rho(m, p.j) : 1.0) * seen[a] * own[a];
      rates.energy_rate += (p.wall ? 1.0 : 0.5) * weight * push * v[a];
    }
  }
  return rates;
}

Rates plain_shifting(Model const& m, std::size_t i) {
  Rates rates;
  std::array<double, 3> slope{};
  double size = 0.0, v2 = 0.0, divergence = 0.0;
  Matrix const moments = plain_moments(m, i, false);
  for (PlainPair const& p : plain_pairs(m, i)) {
    double pair_v2 = 0.0;
    for (std::size_t a = 0; a < axes(m); ++a) {
      slope[a] += mass(m, p.j) / rho(m, p.j) * p.gradient * p.x[a];
      pair_v2 += std::pow(speed(m, i, a) - speed(m, p.j, a), 2);
    }
    v2 = std::max(v2, pair_v2);
  }
  for (std::size_t a = 0; a < axes(m); ++a) {
    size += slope[a] * slope[a];
    divergence += moments[a][a];
  }
  double const inside = std::clamp((divergence / m.dimension - 0.75) / 0.2, 0.0, 1.0);
  double factor = 2.0 * plain_smoothing(m, i) * std::sqrt(v2) * inside;
  if (factor * std::sqrt(size) > 0.5 * std::sqrt(v2))
    factor = 0.5 * std::sqrt(v2) / std::sqrt(size);
  for (std::size_t a = 0; a < axes(m); ++a) rates.drift[a] = -factor * slope[a];
  return rates;
}

constexpr Option options[] = {
    {"morris", [](Numerics& n) { n.physical_viscosity = ViscosityForm::morris; }, plain_morris},
    {"monaghan_cleary", [](Numerics& n) { n.physical_viscosity = ViscosityForm::monaghan_cleary; },
     plain_cleary},
    {"xsph", [](Numerics& n) { n.xsph = 0.5; }, plain_xsph},
    {"penalty", [](Numerics& n) { n.penalty.strength = 2e3; }, plain_penalty},
    {"gradient_diffusion",
     [](Numerics& n) {
       n.density_diffusion = 0.1;
       n.diffusion = DiffusionForm::gradient;
     },
     plain_diffusion},
    {"gradient_correction",
     [](Numerics& n) { n.gradient_correction = GradientCorrection::bonet_lok; }, plain_correction},
    {"gradient_correction_mixed",
     [](Numerics& n) {
       n.gradient_correction = GradientCorrection::bonet_lok;
       n.continuity = ContinuityForm::volume;
       n.momentum = MomentumForm::mixed;
     },
     plain_correction},
    {"shifting", [](Numerics& n) { n.shifting = 2.0; }, plain_shifting},
};

/// Pressures and speeds of sound that no equation of state need allow.
void set_matter(ParticleStore& store) {
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    auto const id = static_cast<double>(store.id()[i]);
    store.scalar(Field::pressure)[i] = 1e5 * (1.0 + std::sin(1.7 * id));
    store.scalar(Field::sound_speed)[i] = 100.0 + std::cos(id);
  }
}

/// The rates of the optional terms alone.
void sweep(Model& model) {
  Search search(search_settings(model));
  search.refresh(model.particles);
  auto const backend = make_options_of(model);
  backend->gather(model.particles, search, model.walls, 0.0);
  backend->sweep(model.particles, search);
}

/// Rounding of one number times the cancellation of pair sums; measured below 2e-5 (corrections of
/// gradients in single precision) and 1e-13.
double share_of(Precision precision) { return precision == Precision::mixed ? 5e-5 : 1e-12; }

/// Of about sixty particles.
void expect_rates(Model const& model, Rates (*plain_of)(Model const&, std::size_t), double share) {
  ParticleStore const& store = model.particles;
  bool const drifts = store.has(Field::drift);
  std::size_t const count = store.range(Kind::fluid).size();
  for (std::size_t i = 0; i < count; i += 1 + count / 60) {
    Rates const plain = plain_of(model, i);
    for (int axis = 0; axis < model.dimension; ++axis) {
      auto const a = static_cast<std::size_t>(axis);
      EXPECT_NEAR(store.component(Field::acceleration, axis)[i], plain.acceleration[a],
                  share * largest(store, Field::acceleration, axis));
      double const drift = drifts ? store.component(Field::drift, axis)[i] : 0.0;
      EXPECT_NEAR(drift, plain.drift[a],
                  share * (drifts ? largest(store, Field::drift, axis) : 1.0));
    }
    EXPECT_NEAR(store.scalar(Field::density_rate)[i], plain.density_rate,
                share * largest(store, Field::density_rate, 0));
    EXPECT_NEAR(store.scalar(Field::energy_rate)[i], plain.energy_rate,
                share * largest(store, Field::energy_rate, 0));
  }
}

using Variant = std::tuple<int, Precision, std::size_t>;

class OptionTerm : public testing::TestWithParam<Variant> {
 protected:
  Option const& option() const { return options[std::get<std::size_t>(GetParam())]; }

  /// A disordered box of two liquids whose particles have smoothing lengths of their own.
  Model box() const {
    RandomBox box;
    box.dimension = std::get<int>(GetParam());
    box.side = std::array{0, 40, 12, 8}[static_cast<std::size_t>(box.dimension)];
    box.scheme = SchemeName::variable;
    Model model = random_box(box, 1.0);
    model.numerics.precision = std::get<Precision>(GetParam());
    model.materials[0].dynamic_viscosity = 3.0;
    model.materials[1].dynamic_viscosity = 11.0;
    option().choose(model.numerics);
    set_matter(model.particles);
    if (option_parameters(model).moves_places()) model.particles.use(Field::drift);
    return model;
  }

  double share() const { return share_of(std::get<Precision>(GetParam())); }
};

TEST_P(OptionTerm, IsItsFormula) {
  Model model = box();
  sweep(model);
  ParticleStore const& store = model.particles;
  double most = 0.0;
  for (int axis = 0; axis < model.dimension; ++axis)
    for (Field const field : {Field::acceleration, Field::drift})
      if (store.has(field)) most = std::max(most, largest(store, field, axis));
  for (Field const field : {Field::density_rate, Field::energy_rate})
    most = std::max(most, largest(store, field, 0));
  EXPECT_GT(most, 0.0);
  expect_rates(model, option().plain, share());
}

// sum m dv/dt = 0, sum m (v . dv/dt + de/dt) = 0 but for the penalty, whose energy is a potential,
// and sum m drift = 0 for the mean of velocities.
TEST_P(OptionTerm, ConservesMomentumAndEnergy) {
  Model model = box();
  sweep(model);
  ParticleStore const& store = model.particles;
  double power = 0.0, turnover = 1e-300;
  for (int axis = 0; axis < model.dimension; ++axis) {
    auto const a = store.component(Field::acceleration, axis);
    auto const v = store.component(Field::velocity, axis);
    double force = 0.0, size = 1e-300, drift = 0.0, drift_size = 1e-300;
    for (std::size_t i = 0; i < a.size(); ++i) {
      double const m = store.scalar(Field::mass)[i];
      force += m * a[i];
      size += m * std::fabs(a[i]);
      power += m * v[i] * a[i];
      turnover += m * std::fabs(v[i] * a[i]);
      if (!store.has(Field::drift)) continue;
      drift += m * store.component(Field::drift, axis)[i];
      drift_size += m * std::fabs(store.component(Field::drift, axis)[i]);
    }
    EXPECT_LE(std::fabs(force), share() * size);
    if (std::string(option().name) == "xsph") {
      EXPECT_LE(std::fabs(drift), share() * drift_size);
    }
  }
  if (std::string(option().name) == "penalty") return;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    power += store.scalar(Field::mass)[i] * store.scalar(Field::energy_rate)[i];
  EXPECT_LE(std::fabs(power), share() * turnover);
}

std::string name_of(testing::TestParamInfo<Variant> const& info) {
  auto const [dimension, precision, option] = info.param;
  return std::string(options[option].name) + "_" + std::to_string(dimension) + "d_" +
         (precision == Precision::mixed ? "mixed" : "double");
}

INSTANTIATE_TEST_SUITE_P(All, OptionTerm,
                         testing::Combine(testing::Values(1, 2, 3),
                                          testing::Values(Precision::mixed, Precision::full),
                                          testing::Range(std::size_t{0}, std::size(options))),
                         name_of);

/// The same box between walls along x whose particles have any pressure and density, with both
/// signs of pressure; every fifth has no normal, as behind an edge.
Model walled_box(int dimension, Precision precision) {
  RandomBox box;
  box.dimension = dimension;
  box.side = std::array{0, 40, 12, 8}[static_cast<std::size_t>(dimension)];
  box.scheme = SchemeName::variable;
  Model model = walled_random_box(box, 1.0);
  model.numerics.precision = precision;
  model.numerics.gradient_correction = GradientCorrection::bonet_lok;
  set_matter(model.particles);
  ParticleStore& store = model.particles;
  for (std::size_t j = store.range(Kind::wall).begin; j < store.size(); ++j) {
    auto const id = static_cast<double>(store.id()[j]);
    store.scalar(Field::pressure)[j] = 2e5 * std::sin(2.3 * id) - 1e5;
    store.scalar(Field::density)[j] = 1500.0 + 400.0 * std::cos(id);
  }
  for (std::size_t k = 0; k < model.walls.points.size(); k += 5) model.walls.points[k].normal = {};
  return model;
}

TEST(CorrectedGradientAtWalls, IsItsFormula) {
  for (int const dimension : {1, 2, 3})
    for (Precision const precision : {Precision::mixed, Precision::full})
      for (bool const free_slip : {true, false})
        for (bool const mixed : {true, false}) {
          SCOPED_TRACE(std::to_string(dimension) + "D" + (mixed ? ", mixed form" : "") +
                       (free_slip ? ", free slip" : ""));
          Model model = walled_box(dimension, precision);
          for (WallPoint& point : model.walls.points) point.free_slip = free_slip;
          if (mixed) {
            model.numerics.continuity = ContinuityForm::volume;
            model.numerics.momentum = MomentumForm::mixed;
          }
          sweep(model);
          expect_rates(model, plain_correction, share_of(precision));
        }
}

}  // namespace
}  // namespace moraine
