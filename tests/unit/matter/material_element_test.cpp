// Laboratory tests on one point, against closed forms.
//
// Soil: E = 5.84 MPa, nu = 0.3, friction angle 31 deg; the pressure is linear in the density, so
// that it is K (rho / rho_0 - 1).
#include <gtest/gtest.h>

#include <cmath>

#include "matter/point/load_path.hpp"

namespace moraine {
namespace {

constexpr double youngs = 5.84e6;  // Pa
constexpr double poisson = 0.3;
double const bulk = youngs / (3.0 * (1.0 - 2.0 * poisson));
double const shear = youngs / (2.0 * (1.0 + poisson));
double const angle = 31.0 * std::acos(-1.0) / 180.0;

Eos linear_soil() {
  Linear law;
  law.reference_density = 2040.0;
  law.reference_sound_speed = std::sqrt(bulk / law.reference_density);
  law.least_pressure = -std::numeric_limits<double>::infinity();
  return law;
}

/// The cone that touches Mohr and Coulomb in plane strain with associated flow.
DruckerPrager plane_strain_cone(double cohesion = 0.0) {
  double const t = std::tan(angle);
  double const root = std::sqrt(9.0 + 12.0 * t * t);
  return {shear, t / root, 3.0 * cohesion / root};
}

DruckerPrager compression_cone(double cohesion = 0.0) {
  double const s = std::sin(angle);
  double const below = std::sqrt(3.0) * (3.0 - s);
  return {shear, 2.0 * s / below, 6.0 * cohesion * std::cos(angle) / below};
}

ElementState end_of(Strength const& strength, Loading const& loading) {
  return follow(MaterialElement(linear_soil(), strength), loading).back();
}

TEST(MaterialElement, OedometerOfAConeEndsOnTheRayOfItsStresses) {
  DruckerPrager const cone = plane_strain_cone();
  double const strain = std::log(1.01);  // rho / rho_0 = 1.01
  auto const sigma =
      end_of(cone, {.path = LoadPath::uniaxial, .strain = strain, .steps = 1000}).stress();
  EXPECT_NEAR(sigma[1] / sigma[0], 0.455386, 1e-6);
  double const exact = -0.01 * bulk * (1.0 + 2.0 * std::sqrt(3.0) * cone.yield_slope);
  EXPECT_NEAR(sigma[0], exact, 1e-6 * std::fabs(exact));
  EXPECT_NEAR(exact, -76408.92, 0.01);
}

TEST(MaterialElement, ElasticOedometerHasTheCoefficientOfHooke) {
  auto const sigma = end_of(Elastic{shear}, {.path = LoadPath::uniaxial, .strain = 1e-4}).stress();
  EXPECT_NEAR(sigma[1] / sigma[0], poisson / (1.0 - poisson), 1e-4) << "linear in rho, not in eps";
}

TEST(MaterialElement, BiaxialTestMobilisesTheConeInPlaneStrain) {
  Loading const loading{.path = LoadPath::biaxial, .confinement = 100e3, .strain = 0.6};
  auto const sigma = end_of(plane_strain_cone(), loading).stress();
  EXPECT_NEAR(sigma[0], -295.003e3, 5.0);
  EXPECT_NEAR(sigma[1], -100e3, 1e-3);
  EXPECT_NEAR(sigma[2], 0.5 * (sigma[0] + sigma[1]), 30.0);
  // Closed form: sin of the angle that is mobilised is 3 alpha.
  double const s = 3.0 * plane_strain_cone().yield_slope;
  EXPECT_NEAR(sigma[0], -100e3 * (1.0 + s) / (1.0 - s), 5.0);
}

TEST(MaterialElement, BiaxialTestWithCohesion) {
  Loading const loading{.path = LoadPath::biaxial, .confinement = 100e3, .strain = 0.6};
  double const alpha = std::sin(angle) / 3.0;
  DruckerPrager const cone{shear, alpha, 5e3 * std::cos(angle)};
  EXPECT_NEAR(end_of(cone, loading).stress()[0], -330.078e3, 5.0);
}

TEST(MaterialElement, TriaxialCompressionOfTheCompressionCone) {
  Loading const loading{.path = LoadPath::triaxial, .confinement = 100e3, .strain = 0.3};
  EXPECT_NEAR(end_of(compression_cone(), loading).stress()[0], -312.4035e3, 0.1);
  EXPECT_NEAR(end_of(plane_strain_cone(), loading).stress()[0], -219.594e3, 0.5);
}

TEST(MaterialElement, TriaxialTestsOfMohrAndCoulombInBothDirections) {
  MohrCoulomb const law{shear, angle, 5e3};
  double const ratio = (1.0 + std::sin(angle)) / (1.0 - std::sin(angle));
  double const strength = 2.0 * law.cohesion * std::sqrt(ratio);
  Loading loading{.path = LoadPath::triaxial, .confinement = 100e3, .strain = 0.3};
  EXPECT_NEAR(end_of(law, loading).stress()[0], -(100e3 * ratio + strength), 0.1);
  loading.strain = -0.3;
  EXPECT_NEAR(end_of(law, loading).stress()[0], -(100e3 - strength) / ratio, 0.1);
  loading = {.path = LoadPath::biaxial, .confinement = 100e3, .strain = 0.3};
  EXPECT_NEAR(end_of(law, loading).stress()[0], -(100e3 * ratio + strength), 0.1);
}

TEST(MaterialElement, UnconfinedCompressionOfMohrAndCoulomb) {
  MohrCoulomb const law{shear, angle, 5e3};
  double const exact = 2.0 * law.cohesion * std::cos(angle) / (1.0 - std::sin(angle));
  EXPECT_NEAR(exact, 17.675e3, 1.0);
  EXPECT_NEAR(end_of(law, {.path = LoadPath::triaxial, .strain = 0.05}).stress()[0], -exact, 0.1);
}

TEST(MaterialElement, ElasticShearOscillatesAsJaumannsRateSays) {
  auto const sigma =
      end_of(Elastic{shear}, {.path = LoadPath::shear, .strain = 1.0, .steps = 2000}).stress();
  EXPECT_NEAR(sigma[3] / shear, std::sin(1.0), 1e-6);
  EXPECT_NEAR(sigma[0] / shear, 1.0 - std::cos(1.0), 1e-6);
  EXPECT_NEAR(sigma[1] / shear, -(1.0 - std::cos(1.0)), 1e-6);
}

TEST(MaterialElement, ShearUnderPressureYieldsOnTheCone) {
  DruckerPrager const cone = plane_strain_cone();
  ElementState const state =
      end_of(cone, {.path = LoadPath::shear, .confinement = 100e3, .strain = 0.4, .steps = 100000});
  EXPECT_NEAR(shear_norm(state.shear.stress), 49.3675e3, 0.1);
  EXPECT_NEAR(state.stress()[3], 49.3555e3, 1.0);
  EXPECT_NEAR(state.stress()[0], -98.915e3, 0.6) << "tau^2 / G above -p";
  EXPECT_NEAR(state.stress()[1], -101.085e3, 0.6);
  EXPECT_NEAR(state.pressure, 100e3, 1e-6);
}

TEST(MaterialElement, AConeBearsNoShearBeyondItsApex) {
  DruckerPrager const cone = plane_strain_cone(5e3);
  double const apex = cone.shear_strength / (3.0 * cone.yield_slope);
  EXPECT_NEAR(3.0 * apex, 24.964e3, 1.0);
  EXPECT_EQ(shear_norm(cone.limit({1e6, -1e6, 0.0, 2e5, 0.0, 0.0}, -1.001 * apex)), 0.0);
  EXPECT_GT(shear_norm(cone.limit({1e6, -1e6, 0.0, 2e5, 0.0, 0.0}, -0.999 * apex)), 0.0);
}

// Total work = elastic energy + plastic work, of pressure and shear.
TEST(MaterialElement, WorkIsElasticEnergyAndPlasticWork) {
  VonMises const metal{shear, 20e3};
  ElementState const state =
      end_of(metal, {.path = LoadPath::shear, .strain = 0.5, .steps = 20000});
  double const work = state.specific_energy * state.density;
  double const elastic = contraction(state.shear.stress, state.shear.stress) / (4.0 * shear);
  EXPECT_NEAR(work, elastic + state.shear.plastic_work, 1e-4 * work);
  EXPECT_NEAR(shear_norm(state.shear.stress), 20e3 / std::sqrt(3.0), 1e-6);
  EXPECT_GT(state.shear.plastic_strain, 0.9 * 0.5 / std::sqrt(3.0));
}

}  // namespace
}  // namespace moraine
