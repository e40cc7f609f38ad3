// Each optional term against its formula, written plainly over all pairs of a disordered box.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "base/vec3.hpp"
#include "support/plain_options.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

struct Option {
  char const* name;
  void (*choose)(Numerics&);
  Rates (*plain)(Model const&, std::size_t);
};

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
