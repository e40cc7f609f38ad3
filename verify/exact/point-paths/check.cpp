// The tests of a soil laboratory on one point of a material, against closed forms.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "matter/point/load_path.hpp"

namespace moraine {
namespace {

constexpr double youngs_modulus = 5.84e6;  // Pa
constexpr double poissons_ratio = 0.3;
constexpr double density = 2040.0;     // kg/m^3
constexpr double confinement = 100e3;  // Pa
constexpr double cohesion = 5e3;       // Pa, where there is one
constexpr double unconfined_strain = 0.05, strain = 0.6;
double const bulk = youngs_modulus / (3.0 * (1.0 - 2.0 * poissons_ratio));
double const shear = youngs_modulus / (2.0 * (1.0 + poissons_ratio));
double const angle = 31.0 * std::numbers::pi / 180.0;

/// K (rho / rho_0 - 1), down to a pressure.
Eos soil(double least_pressure = -std::numeric_limits<double>::infinity()) {
  Linear law;
  law.reference_density = density;
  law.reference_sound_speed = std::sqrt(bulk / density);
  law.least_pressure = least_pressure;
  return law;
}

/// The cone that touches Mohr and Coulomb in plane strain where flow is associated.
DruckerPrager plane_strain_cone(double c = 0.0) {
  double const t = std::tan(angle);
  double const root = std::sqrt(9.0 + 12.0 * t * t);
  return {shear, t / root, 3.0 * c / root};
}

/// The cone that does so where it is not, without dilation.
DruckerPrager plane_flow_cone(double c = 0.0) {
  return {shear, std::sin(angle) / 3.0, c * std::cos(angle)};
}

/// The cone through the corners of compression.
DruckerPrager compression_cone(double c = 0.0) {
  double const s = std::sin(angle);
  double const below = std::sqrt(3.0) * (3.0 - s);
  return {shear, 2.0 * s / below, 6.0 * c * std::cos(angle) / below};
}

Symmetric<3> end_of(Strength const& strength, Loading const& loading) {
  return follow(MaterialElement(soil(), strength), loading).back().stress();
}

class Rows {
 public:
  void add(std::string const& what, double measured, double exact, char const* unit) {
    results_.push_back(compare("point-paths: " + what, measured, exact, 1e-6 * std::fabs(exact),
                               unit, "exact: closed form"));
  }
  void add_none(std::string const& what, double measured, std::string note) {
    results_.push_back(at_most("point-paths: " + what, measured, 1e-6, "-", std::move(note)));
  }
  std::vector<CheckResult> take() { return std::move(results_); }

 private:
  std::vector<CheckResult> results_;
};

/// One-dimensional compression of a cone without cohesion, which slides from the start:
///   sigma_v = -p (1 + 2 sqrt3 alpha),   sigma_h / sigma_v = (1 - sqrt3 alpha) / (1 + 2 sqrt3
///   alpha)
void add_oedometer(Rows& rows) {
  DruckerPrager const cone = plane_strain_cone();
  double const a = std::sqrt(3.0) * cone.yield_slope;
  auto const sigma = end_of(cone, {.path = LoadPath::uniaxial, .strain = std::log(1.01)});
  rows.add("oedometer, axial stress", sigma[0], -0.01 * bulk * (1.0 + 2.0 * a), "Pa");
  rows.add("oedometer, stress across / along", sigma[1] / sigma[0], (1.0 - a) / (1.0 + 2.0 * a),
           "-");
}

/// Plane strain without dilation: sigma_zz becomes the mean of the two others, sqrt(J2) half of
/// their difference.
void add_biaxial(Rows& rows) {
  Loading const loading{.path = LoadPath::biaxial, .confinement = confinement, .strain = strain};
  auto const exact = [](DruckerPrager const& cone) {
    double const a = 3.0 * cone.yield_slope;
    return -(2.0 * cone.shear_strength + confinement * (1.0 + a)) / (1.0 - a);
  };
  auto const add = [&](char const* what, DruckerPrager const& cone) {
    auto const sigma = end_of(cone, loading);
    rows.add(fmt::format("biaxial, {}", what), sigma[0], exact(cone), "Pa");
    rows.add(fmt::format("biaxial, {}, out of plane", what), sigma[2],
             0.5 * (exact(cone) - confinement), "Pa");
  };
  add("cone of plane strain", plane_strain_cone());
  add("cone of plane flow", plane_flow_cone());
  add("cone of plane flow, cohesive", plane_flow_cone(cohesion));
  double const ratio = (1.0 + std::sin(angle)) / (1.0 - std::sin(angle));
  rows.add("biaxial, Mohr and Coulomb, cohesive",
           end_of(MohrCoulomb{shear, angle, cohesion}, loading)[0],
           -(confinement * ratio + 2.0 * cohesion * std::sqrt(ratio)), "Pa");
}

/// Compression of a cylinder: sqrt(J2) is the difference of both stresses / sqrt(3).
void add_triaxial(Rows& rows) {
  auto const add = [&](char const* what, DruckerPrager const& cone, double held) {
    double const a = cone.yield_slope, r = 1.0 / std::sqrt(3.0);
    Loading const loading{.path = LoadPath::triaxial,
                          .confinement = held,
                          .strain = held > 0.0 ? strain : unconfined_strain};
    rows.add(what, end_of(cone, loading)[0],
             -(cone.shear_strength + held * (r + 2.0 * a)) / (r - a), "Pa");
  };
  add("triaxial, cone of compression", compression_cone(), confinement);
  add("triaxial, cone of plane strain", plane_strain_cone(), confinement);
  add("unconfined, cone of compression", compression_cone(cohesion), 0.0);
  add("unconfined, cone of plane strain", plane_strain_cone(cohesion), 0.0);
}

/// sigma_1 = ratio sigma_3 + 2 c sqrt(ratio), whichever of them is held.
void add_mohr_coulomb(Rows& rows) {
  MohrCoulomb const law{shear, angle, cohesion};
  double const ratio = (1.0 + std::sin(angle)) / (1.0 - std::sin(angle));
  double const strength = 2.0 * cohesion * std::sqrt(ratio);
  Loading loading{.path = LoadPath::triaxial, .confinement = confinement, .strain = strain};
  rows.add("triaxial compression, Mohr and Coulomb", end_of(law, loading)[0],
           -(confinement * ratio + strength), "Pa");
  loading.strain = -strain;
  rows.add("triaxial extension, Mohr and Coulomb", end_of(law, loading)[0],
           -(confinement - strength) / ratio, "Pa");
  rows.add("unconfined, Mohr and Coulomb",
           end_of(law, {.path = LoadPath::triaxial, .strain = unconfined_strain})[0], -strength,
           "Pa");
}

/// Simple shear by one: Jaumann's rate turns the stress with the material.
void add_elastic_shear(Rows& rows) {
  auto const sigma =
      end_of(Elastic{shear}, {.path = LoadPath::shear, .strain = 1.0, .steps = 2000});
  rows.add("elastic shear, sigma_xy / G", sigma[3] / shear, std::sin(1.0), "-");
  rows.add("elastic shear, sigma_xx / G", sigma[0] / shear, 1.0 - std::cos(1.0), "-");
  rows.add("elastic shear, sigma_yy / G", sigma[1] / shear, std::cos(1.0) - 1.0, "-");
}

/// Simple shear of a cone under pressure. Where turning, straining and sliding balance,
///   s_xx = -s_yy = tau^2 / G,   s_xy^2 = tau^2 - s_xx^2,   tau = 3 alpha p
void add_shear_of_cone(Rows& rows) {
  DruckerPrager const cone = plane_strain_cone();
  auto const sigma = end_of(
      cone, {.path = LoadPath::shear, .confinement = confinement, .strain = 0.4, .steps = 1000000});
  double const tau = 3.0 * cone.yield_slope * confinement;
  double const turned = tau * tau / shear;
  double const s_xx = sigma[0] + confinement;
  rows.add("shear of a cone, sqrt(J2)", std::hypot(s_xx, sigma[3]), tau, "Pa");
  rows.add("shear of a cone, sigma_xy", sigma[3], std::sqrt(tau * tau - turned * turned), "Pa");
  rows.add("shear of a cone, sigma_xx", sigma[0], turned - confinement, "Pa");
  rows.add("shear of a cone, sigma_yy", sigma[1], -turned - confinement, "Pa");
}

/// The stress of a cone that is pulled apart along one axis.
Symmetric<3> pulled_apart(double c) {
  constexpr double extension = 0.05;
  return follow(MaterialElement(soil(-c / std::tan(angle)), plane_strain_cone(c)),
                {.path = LoadPath::uniaxial, .strain = -extension})
      .back()
      .stress();
}

/// It ends at its apex: the sum of the stresses is 3 c / tan(phi), none is sheared.
void add_apex(Rows& rows) {
  double const apex = cohesion / std::tan(angle);
  auto const sigma = pulled_apart(cohesion);
  rows.add("apex, sum of the stresses", sigma[0] + sigma[1] + sigma[2], 3.0 * apex, "Pa");
  rows.add("apex, stress along", sigma[0], apex, "Pa");
  auto const loose = pulled_apart(0.0);
  rows.add_none("apex without cohesion", std::sqrt(contraction(loose, loose)) / bulk,
                "size of the stress / bulk modulus");
}

}  // namespace

std::vector<CheckResult> check_point_paths(Effort) {
  Rows rows;
  add_oedometer(rows);
  add_biaxial(rows);
  add_triaxial(rows);
  add_mohr_coulomb(rows);
  add_elastic_shear(rows);
  add_shear_of_cone(rows);
  add_apex(rows);
  return rows.take();
}

}  // namespace moraine
