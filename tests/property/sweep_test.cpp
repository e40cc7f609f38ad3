// Every flavour of the sweep against the plain loop, and the symmetry of pairs.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>

#include "step/simulation_setup.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

using Variant = std::tuple<int, Flavour, KernelName, SchemeName>;

/// A state that no equation of state need allow: any pressure, the reference sound speed.
void set_matter(ParticleStore& store, bool reference_density_only) {
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    auto const id = static_cast<double>(store.id()[i]);
    store.scalar(Field::pressure)[i] = 1e5 * (1.0 + std::sin(1.7 * id));
    store.scalar(Field::sound_speed)[i] = 100.0;
    if (reference_density_only) store.scalar(Field::density)[i] = 1000.0;
  }
}

struct Swept {
  ParticleStore store{1};
  SweepOutcome outcome;
};

Swept sweep(Model model, Flavour flavour, SchemeName scheme) {
  Search search(search_settings(model));
  search.refresh(model.particles);
  // A liquid's wall particles have its reference density, others that of the fluid before them.
  bool const walls = model.particles.range(Kind::wall).size() > 0;
  set_matter(model.particles, walls && scheme == SchemeName::liquid);
  auto const pairs = make_pair_backend(model.dimension, flavour, model.numerics.kernel, scheme,
                                       sweep_parameters(model), reference_densities(model));
  pairs->gather_fluid(model.particles, search, 0.0);
  pairs->gather_walls(model.particles, search, model.walls);
  Swept swept;
  swept.outcome = pairs->sweep(model.particles, search);
  swept.store = std::move(model.particles);
  return swept;
}

void expect_equal(ParticleStore const& a, ParticleStore const& b, Field field, int axis,
                  double share) {
  double const tolerance = share * largest(b, field, axis);
  for (std::size_t i = 0; i < b.range(Kind::fluid).size(); ++i)
    ASSERT_NEAR(a.component(field, axis)[i], b.component(field, axis)[i], tolerance)
        << info(field).name << " " << axis << " particle " << i;
}

class Sweep : public testing::TestWithParam<Variant> {
 protected:
  RandomBox box() const {
    RandomBox box;
    box.dimension = std::get<int>(GetParam());
    box.side = std::array{0, 200, 24, 10}[static_cast<std::size_t>(box.dimension)];
    box.scheme = std::get<SchemeName>(GetParam());
    return box;
  }
  Model prepared(Model model) const {
    model.numerics.kernel = std::get<KernelName>(GetParam());
    model.numerics.density_diffusion = 0.1;
    return model;
  }
  // Rounding of one number (6e-8, 1e-16) times the cancellation of pair forces that are larger than
  // their sum; measured 5e-7 and 1e-15.
  double share() const { return std::get<Flavour>(GetParam()) == Flavour::mixed ? 5e-6 : 1e-14; }

  void compare_with_reference(Model const& model) const {
    Swept const plain = sweep(model, Flavour::reference, box().scheme);
    Swept const fast = sweep(model, std::get<Flavour>(GetParam()), box().scheme);
    for (int axis = 0; axis < model.dimension; ++axis)
      expect_equal(fast.store, plain.store, Field::acceleration, axis, share());
    expect_equal(fast.store, plain.store, Field::density_rate, 0, share());
    expect_equal(fast.store, plain.store, Field::energy_rate, 0, share());
    EXPECT_NEAR(fast.outcome.signal_speed, plain.outcome.signal_speed,
                share() * plain.outcome.signal_speed);
    double force = 0.0;
    for (int axis = 0; axis < model.dimension; ++axis)
      force +=
          largest(plain.store, Field::acceleration, axis) * model.particles.scalar(Field::mass)[0];
    auto const count = static_cast<double>(model.particles.range(Kind::fluid).size());
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(fast.outcome.wall_force[axis], plain.outcome.wall_force[axis],
                  share() * force * count);
  }
};

TEST_P(Sweep, AgreesWithThePlainLoopInAPeriodicBox) {
  compare_with_reference(prepared(random_box(box(), 1.0)));
}

TEST_P(Sweep, AgreesWithThePlainLoopAtWalls) {
  compare_with_reference(prepared(walled_random_box(box(), 1.0)));
}

TEST_P(Sweep, PairForcesCancel) {
  Model const model = prepared(random_box(box(), 1.0));
  Swept const swept = sweep(model, std::get<Flavour>(GetParam()), box().scheme);
  ParticleStore const& store = swept.store;
  for (int axis = 0; axis < model.dimension; ++axis) {
    double sum = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
      double const force =
          store.scalar(Field::mass)[i] * store.component(Field::acceleration, axis)[i];
      sum += force;
      size += std::fabs(force);
    }
    EXPECT_LE(std::fabs(sum), 0.1 * share() * size);
  }
}

std::string name_of(testing::TestParamInfo<Variant> const& variant) {
  return std::to_string(std::get<int>(variant.param)) + "D_" +
         (std::get<Flavour>(variant.param) == Flavour::mixed ? "mixed_" : "double_") +
         std::string(kernel_name(std::get<KernelName>(variant.param))) +
         (std::get<SchemeName>(variant.param) == SchemeName::liquid ? "_liquid" : "_compressible");
}

INSTANTIATE_TEST_SUITE_P(
    All, Sweep,
    testing::Combine(testing::Values(1, 2, 3), testing::Values(Flavour::mixed, Flavour::full),
                     testing::Values(KernelName::cubic_spline, KernelName::wendland_c2),
                     testing::Values(SchemeName::liquid, SchemeName::compressible)),
    name_of);

}  // namespace
}  // namespace moraine
