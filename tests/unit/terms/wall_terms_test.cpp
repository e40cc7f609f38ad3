// The terms between a fluid particle and a wall, one pair at a time.
#include <gtest/gtest.h>

#include "terms/sweep_parameters.hpp"
#include "terms/wall_contact.hpp"
#include "terms/wall_pressure.hpp"

namespace moraine {
namespace {

/// A particle that a term can read; only the fields of wall terms.
struct Plain {
  using Number = double;
  static constexpr bool has(PairField) { return true; }
  double pressure_term_value = 0.0;
  double sound_speed_value = 0.0;
  double density_value = 1000.0;

  template <PairField field>
  double get(int = 0) const {
    if (field == PairField::compression) return 0.0;
    if (field == PairField::reference_density) return density_value;
    return field == PairField::pressure_term ? pressure_term_value : sound_speed_value;
  }
};

double contact_stress(double gap) {
  Pair<double, 2> pair{};
  pair.gap = gap;
  pair.mean_density = 1000.0;
  PairRates<double> rates{};
  WallContact<double>{1.0 / 0.005}(pair, Plain{0.0, 30.0}, Plain{0.0, 77.0}, rates);
  EXPECT_EQ(rates.density_rate, 0.0);
  EXPECT_EQ(rates.approach_speed, 0.0);
  return rates.stress;
}

// S = c_i^2 / rho min(2, max(0, 1 - gap / gap_0)) with c_i = 30, rho = 1000, gap_0 = 0.005.
TEST(WallContact, FollowsItsFormula) {
  EXPECT_DOUBLE_EQ(contact_stress(0.0025), 0.45);
  EXPECT_DOUBLE_EQ(contact_stress(0.0), 0.9);       // at the face
  EXPECT_DOUBLE_EQ(contact_stress(-0.0025), 1.35);  // behind it
  EXPECT_DOUBLE_EQ(contact_stress(-0.005), 1.8);
  EXPECT_DOUBLE_EQ(contact_stress(-1.0), 1.8) << "no more than twice the stiffness";
}

TEST(WallContact, DoesNothingBeyondItsGap) {
  for (double const gap : {0.005, 0.00500001, 0.01, 1.0, 1e6}) EXPECT_EQ(contact_stress(gap), 0.0);
}

double pressure_stress(double fluid, double wall) {
  PairRates<double> rates{0.25, 0.0, 0.0};  // what other terms have added stays
  WallPressure{.form = {.mixed = false}}(Pair<double, 2>{}, Plain{fluid, 0.0}, Plain{wall, 0.0},
                                         rates);
  return rates.stress - 0.25;
}

TEST(WallPressure, PushesAndNeverPulls) {
  EXPECT_EQ(pressure_stress(2.0, 3.0), 5.0);
  EXPECT_EQ(pressure_stress(-2.0, 3.0), 1.0);
  EXPECT_EQ(pressure_stress(2.0, -3.0), 0.0);
  EXPECT_EQ(pressure_stress(-2.0, -3.0), 0.0);
}

// (p_i + p_j) / (rho_i rho_j), of p_i = 200 and p_j at densities of 10 and 500.
double mixed_stress(double p_j) {
  PairRates<double> rates{};
  WallPressure{.form = {.mixed = true}}(Pair<double, 2>{}, Plain{200.0 / 100.0, 0.0, 10.0},
                                        Plain{p_j / 250000.0, 0.0, 500.0}, rates);
  return rates.stress;
}

TEST(WallPressure, TakesNoMassOfTheWallInTheMixedForm) {
  EXPECT_DOUBLE_EQ(mixed_stress(300.0), 500.0 / 5000.0);
  EXPECT_EQ(mixed_stress(-300.0), 0.0);
}

}  // namespace
}  // namespace moraine
