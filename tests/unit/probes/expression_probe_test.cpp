// Formulas over three particles whose values are known.
#include "probes/expression_probe.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moraine {
namespace {

/// Masses 1, 2, 3; densities 1, 4, 2: volumes 1, 0.5, 1.5; pressures 10, -20, 30; x = 0, 1, 2;
/// velocities (3, 4), (0, 0), (-5, 12). The last is of another material.
ParticleStore three() {
  ParticleStore store(2);
  double const mass[]{1, 2, 3}, density[]{1, 4, 2}, pressure[]{10, -20, 30};
  double const vx[]{3, 0, -5}, vy[]{4, 0, 12};
  for (std::size_t i = 0; i < 3; ++i) {
    store.append(Kind::fluid, i == 2 ? 1 : 0);
    store.scalar(Field::mass)[i] = mass[i];
    store.scalar(Field::density)[i] = density[i];
    store.scalar(Field::pressure)[i] = pressure[i];
    store.component(Field::position, 0)[i] = static_cast<double>(i);
    store.component(Field::velocity, 0)[i] = vx[i];
    store.component(Field::velocity, 1)[i] = vy[i];
  }
  return store;
}

double reduced(std::string const& formula, Reduction reduction,
               MeanWeight weight = MeanWeight::mass, Selection const& selection = {}) {
  return reduce_formula(three(), selection, ParticleFormula(formula), reduction, weight, 0.25, 7.0)
      .value;
}

TEST(Expression, ReducesInAllWays) {
  EXPECT_DOUBLE_EQ(reduced("pressure", Reduction::max), 30.0);
  EXPECT_DOUBLE_EQ(reduced("pressure", Reduction::min), -20.0);
  EXPECT_DOUBLE_EQ(reduced("pressure", Reduction::sum), 20.0);
  EXPECT_DOUBLE_EQ(reduced("pressure", Reduction::integral), 10.0 - 10.0 + 45.0);
  EXPECT_DOUBLE_EQ(reduced("pressure", Reduction::mean), (10.0 - 40.0 + 90.0) / 6.0);
  EXPECT_DOUBLE_EQ(reduced("pressure", Reduction::mean, MeanWeight::volume), 45.0 / 3.0);
  EXPECT_DOUBLE_EQ(reduced("pressure", Reduction::mean, MeanWeight::number), 20.0 / 3.0);
}

TEST(Expression, KnowsAllFields) {
  EXPECT_DOUBLE_EQ(reduced("0.5 * mass * speed^2", Reduction::sum), 12.5 + 0.5 * 3 * 169);
  EXPECT_DOUBLE_EQ(reduced("velocity_x + 10 * velocity_y", Reduction::max), 115.0);
  EXPECT_DOUBLE_EQ(reduced("volume", Reduction::sum), 3.0);
  EXPECT_DOUBLE_EQ(reduced("x", Reduction::mean, MeanWeight::number), 1.0);
  EXPECT_DOUBLE_EQ(reduced("y + z + velocity_z + burn_fraction", Reduction::sum), 0.0);
  EXPECT_DOUBLE_EQ(reduced("time + smoothing_length", Reduction::max), 7.25);
  EXPECT_DOUBLE_EQ(reduced("distension", Reduction::max), 1.0) << "without pores";
  EXPECT_DOUBLE_EQ(reduced("1", Reduction::integral), 3.0) << "the volume";
}

TEST(Expression, CountsTheChosenParticlesOnly) {
  EXPECT_DOUBLE_EQ(reduced("pressure", Reduction::max, MeanWeight::mass, {{0}, std::nullopt}),
                   10.0);
  PlaceBox const box{{0.5, -1.0, 0.0}, {2.5, 1.0, 0.0}};
  EXPECT_DOUBLE_EQ(reduced("mass", Reduction::sum, MeanWeight::mass, {{}, box}), 5.0);
  EXPECT_DOUBLE_EQ(reduced("mass", Reduction::sum, MeanWeight::mass, {{0}, box}), 2.0);
}

TEST(Expression, OfNothingAndOfNoNumber) {
  Selection const none{{9}, std::nullopt};
  EXPECT_TRUE(std::isnan(reduced("pressure", Reduction::max, MeanWeight::mass, none)));
  EXPECT_TRUE(std::isnan(reduced("pressure", Reduction::mean, MeanWeight::mass, none)));
  EXPECT_EQ(reduced("pressure", Reduction::sum, MeanWeight::mass, none), 0.0);
  EXPECT_TRUE(std::isnan(reduced("sqrt(pressure)", Reduction::max)));
}

TEST(ParticleFormula, NamesWhatItDoesNotKnow) {
  auto const unknown = unknown_name("1.5e-3 * max(presure, 2E5)");
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->name, "presure");
  EXPECT_EQ(unknown->position, 14U);
  EXPECT_FALSE(unknown_name("1e3*pressure + sin(pi*x) ? e : g0"));
  EXPECT_EQ(unknown_name("2 * t")->name, "t");
}

TEST(ParticleFormula, SaysWhatIsWrong) {
  EXPECT_EQ(formula_fault("pressure / 2"), "");
  EXPECT_NE(formula_fault("(pressure"), "");
  EXPECT_NE(formula_fault("pressure = 2"), "");
  EXPECT_NE(formula_fault("pressure, 2"), "");
}

}  // namespace
}  // namespace moraine
