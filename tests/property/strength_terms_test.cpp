// The pair terms of solids against their formulas, written plainly over all pairs of a disordered
// box of a solid and a fluid.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "smoothing/any_kernel.hpp"
#include "support/option_reference.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

struct Rates {
  std::array<double, 3> acceleration{};
  double energy_rate = 0.0;
  Matrix gradient{};
};

std::size_t axes(Model const& m) { return static_cast<std::size_t>(m.dimension); }
double rho(Model const& m, std::size_t i) { return m.particles.scalar(Field::density)[i]; }
double mass(Model const& m, std::size_t i) { return m.particles.scalar(Field::mass)[i]; }
double speed(Model const& m, std::size_t i, std::size_t a) {
  return m.particles.component(Field::velocity, static_cast<int>(a))[i];
}

/// Entry of the predicted stress; xy, xz, yz lie behind the diagonal.
double stress(Model const& m, std::size_t i, std::size_t a, std::size_t b) {
  std::size_t const k = a == b ? a : axes(m) + a + b - 1;
  return m.particles.component(Field::predicted_stress, static_cast<int>(k))[i];
}

Matrix artificial(Model const& m, std::size_t i) {
  Matrix r{};
  if (m.numerics.artificial_stress == 0.0 ||
      !is_solid(m.materials[m.particles.material()[i]].strength))
    return r;
  Matrix3 full_stress{};
  double trace = 0.0;
  for (std::size_t a = 0; a < axes(m); ++a) {
    for (std::size_t b = 0; b < axes(m); ++b) full_stress[a][b] = stress(m, i, a, b);
    trace += full_stress[a][a];
  }
  if (m.dimension == 1) full_stress[1][1] = full_stress[2][2] = -0.5 * trace;
  if (m.dimension == 2) full_stress[2][2] = -trace;
  double const p = m.particles.scalar(Field::pressure)[i];
  Principal state = principal({full_stress[0][0] - p, full_stress[1][1] - p, full_stress[2][2] - p,
                               full_stress[0][1], full_stress[0][2], full_stress[1][2]});
  for (double& value : state.values)
    value = -m.numerics.artificial_stress * std::max(value, 0.0) / (rho(m, i) * rho(m, i));
  Matrix3 const whole = full(from_principal(state));
  for (std::size_t a = 0; a < axes(m); ++a)
    for (std::size_t b = 0; b < axes(m); ++b) r[a][b] = whole[a][b];
  return r;
}

Rates plain(Model const& m, std::size_t i) {
  Rates rates;
  double const rho_i = rho(m, i);
  Matrix const r_i = artificial(m, i);
  AnyKernel<1> const kernel_1(m.numerics.kernel);
  AnyKernel<2> const kernel_2(m.numerics.kernel);
  AnyKernel<3> const kernel_3(m.numerics.kernel);
  double const q = 1.0 / m.numerics.smoothing_factor;
  double const at_spacing = m.dimension == 1   ? kernel_1.sigma * kernel_1.shape(q)
                            : m.dimension == 2 ? kernel_2.sigma * kernel_2.shape(q)
                                               : kernel_3.sigma * kernel_3.shape(q);
  for (PlainPair const& p : plain_pairs(m, i)) {
    double const rho_j = rho(m, p.j);
    bool const mixed = m.numerics.momentum == MomentumForm::mixed;
    double const of_i = mixed ? 1.0 / (rho_i * rho_j) : 1.0 / (rho_i * rho_i);
    double const of_j = mixed ? 1.0 / (rho_i * rho_j) : 1.0 / (rho_j * rho_j);
    Matrix const r_j = artificial(m, p.j);
    double const f = std::pow(p.kernel * std::pow(p.h, m.dimension) / at_spacing, 4);
    for (std::size_t a = 0; a < axes(m); ++a) {
      double const v = speed(m, i, a) - speed(m, p.j, a);
      double own = 0.0, other = 0.0, apart = 0.0;
      for (std::size_t b = 0; b < axes(m); ++b) {
        double const slope = p.gradient * p.x[b];
        own += of_i * stress(m, i, a, b) * slope;
        other += of_j * stress(m, p.j, a, b) * slope;
        apart += f * (r_i[a][b] + r_j[a][b]) * slope;
        rates.gradient[a][b] -= mass(m, p.j) / rho_j * v * slope;
      }
      rates.acceleration[a] += mass(m, p.j) * (own + other + apart);
      rates.energy_rate -= mass(m, p.j) * v * (own + 0.5 * apart);
    }
  }
  return rates;
}

enum class Form { conservative, mixed, with_artificial_stress };
using Variant = std::tuple<int, Precision, Form>;

class StrengthTerms : public testing::TestWithParam<Variant> {
 protected:
  /// Every second material of the box is a solid; smoothing lengths vary.
  Model box() const {
    RandomBox box;
    box.dimension = std::get<int>(GetParam());
    box.side = std::array{0, 40, 12, 8}[static_cast<std::size_t>(box.dimension)];
    box.scheme = SchemeName::variable;
    Model model = random_box(box, 1.0);
    model.numerics.precision = std::get<Precision>(GetParam());
    if (std::get<Form>(GetParam()) == Form::mixed) model.numerics.momentum = MomentumForm::mixed;
    if (std::get<Form>(GetParam()) == Form::with_artificial_stress)
      model.numerics.artificial_stress = 0.4;
    model.materials[1].strength = Elastic{1e6};
    ParticleStore& store = model.particles;
    for (Field const field : solid_fields) store.use(field);
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
      auto const id = static_cast<double>(store.id()[i]);
      store.scalar(Field::pressure)[i] = 4e4 * std::sin(1.7 * id);
      if (store.material()[i] != 1) continue;
      for (int k = 0; k < components(Rank::symmetric, model.dimension); ++k)
        store.component(Field::predicted_stress, k)[i] = 1e5 * std::sin(id + 2.1 * k);
    }
    return model;
  }

  void sweep(Model& model) const {
    Search search(search_settings(model));
    search.refresh(model.particles);
    auto const backend = make_strength_of(model);
    backend->gather(model.particles, search, model.walls, 0.0);
    backend->sweep(model.particles, search);
  }

  double share() const {
    return std::get<Precision>(GetParam()) == Precision::mixed ? 3e-6 : 1e-13;
  }
};

TEST_P(StrengthTerms, AreTheirFormulas) {
  Model model = box();
  sweep(model);
  ParticleStore const& store = model.particles;
  std::size_t const count = store.range(Kind::fluid).size();
  for (std::size_t i = 0; i < count; i += 1 + count / 60) {
    Rates const rates = plain(model, i);
    for (int a = 0; a < model.dimension; ++a) {
      EXPECT_NEAR(store.component(Field::acceleration, a)[i],
                  rates.acceleration[static_cast<std::size_t>(a)],
                  share() * largest(store, Field::acceleration, a));
      // Fluids that touch no solid are left alone.
      bool const solid = store.material()[i] == 1;
      for (int b = 0; solid && b < model.dimension; ++b) {
        int const k = a * model.dimension + b;
        EXPECT_NEAR(store.component(Field::velocity_gradient, k)[i],
                    rates.gradient[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)],
                    share() * largest(store, Field::velocity_gradient, k));
      }
    }
    EXPECT_NEAR(store.scalar(Field::energy_rate)[i], rates.energy_rate,
                share() * largest(store, Field::energy_rate, 0));
  }
}

// sum m dv/dt = 0 and sum m (v . dv/dt + de/dt) = 0, with the fluid that touches the solid.
TEST_P(StrengthTerms, ConserveMomentumAndEnergy) {
  Model model = box();
  sweep(model);
  ParticleStore const& store = model.particles;
  double power = 0.0, turnover = 0.0;
  for (int axis = 0; axis < model.dimension; ++axis) {
    auto const a = store.component(Field::acceleration, axis);
    auto const v = store.component(Field::velocity, axis);
    double force = 0.0, size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      double const m = store.scalar(Field::mass)[i];
      force += m * a[i];
      size += m * std::fabs(a[i]);
      power += m * v[i] * a[i];
      turnover += m * std::fabs(v[i] * a[i]);
    }
    EXPECT_GT(size, 0.0);
    EXPECT_LE(std::fabs(force), share() * size);
  }
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    power += store.scalar(Field::mass)[i] * store.scalar(Field::energy_rate)[i];
  EXPECT_LE(std::fabs(power), share() * turnover);
}

std::string name_of(testing::TestParamInfo<Variant> const& info) {
  auto const [dimension, precision, form] = info.param;
  return std::to_string(dimension) + "d_" + (precision == Precision::mixed ? "single" : "double") +
         (form == Form::conservative ? "_conservative"
          : form == Form::mixed      ? "_mixed"
                                     : "_artificial_stress");
}

INSTANTIATE_TEST_SUITE_P(All, StrengthTerms,
                         testing::Combine(testing::Values(1, 2, 3),
                                          testing::Values(Precision::mixed, Precision::full),
                                          testing::Values(Form::conservative, Form::mixed,
                                                          Form::with_artificial_stress)),
                         name_of);

}  // namespace
}  // namespace moraine
