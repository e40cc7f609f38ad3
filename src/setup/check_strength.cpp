#include "setup/check_strength.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <variant>

namespace moraine {
namespace {

struct Constant {
  std::string_view key;
  std::optional<double> StrengthSpec::*value;
  std::array<bool, 5> belongs;  // by StrengthKind
};

constexpr std::array<Constant, 6> constants{{
    {"shear_modulus", &StrengthSpec::shear_modulus, {false, true, true, true, true}},
    {"yield_strength", &StrengthSpec::yield_strength, {false, false, true, false, false}},
    {"yield_slope", &StrengthSpec::yield_slope, {false, false, false, true, false}},
    {"shear_strength", &StrengthSpec::shear_strength, {false, false, false, true, false}},
    {"friction_angle", &StrengthSpec::friction_angle, {false, false, false, false, true}},
    {"cohesion", &StrengthSpec::cohesion, {false, false, false, false, true}},
}};

/// Least pressure that the equation of state lets a material have; -infinity without a floor.
double floor_of(Eos const& eos) {
  return std::visit(
      [](auto const& law) {
        if constexpr (requires { law.least_pressure; })
          return law.least_pressure;
        else
          return -std::numeric_limits<double>::infinity();
      },
      eos);
}

/// Pressure at which a material bears no shear any more; -infinity for one that always does.
double apex_of(Strength const& strength) {
  double const never = -std::numeric_limits<double>::infinity();
  if (auto const* cone = std::get_if<DruckerPrager>(&strength))
    return cone->yield_slope > 0.0 ? -cone->shear_strength / (3.0 * cone->yield_slope) : never;
  if (auto const* pyramid = std::get_if<MohrCoulomb>(&strength))
    return pyramid->friction_angle > 0.0 ? -pyramid->cohesion / std::tan(pyramid->friction_angle)
                                         : never;
  return never;
}

/// Without dilation plane strain ends at s_zz = 0, and compression along one axis to sigma_3 yields
/// where -sigma_3 / 2 = k - 3 alpha sigma_3 / 2: nowhere from 3 alpha = 1 on, which is no sine of a
/// friction angle.
void add_slope_warning(Case const& c, MaterialSpec const& material,
                       std::vector<InputProblem>& warnings) {
  double const slope = 3.0 * material.strength.yield_slope.value_or(0.0);
  if (slope < 1.0) return;
  warnings.push_back(problem_of(
      c, "material." + material.name + ".strength.yield_slope",
      fmt::format("lets plane strain bear any compression: three times it is {:.3g}, and "
                  "from one on it never yields there",
                  slope),
      "take kind = \"mohr_coulomb\""));
}

}  // namespace

void check_strength(MaterialSpec const& material, std::string const& key, Source& source) {
  StrengthSpec const& spec = material.strength;
  std::string const prefix = key + "strength.";
  if (source.has_problem(prefix + "kind")) return;
  auto const kind = static_cast<std::size_t>(spec.kind);
  std::string_view const name = strength_names[kind];
  for (Constant const& constant : constants) {
    std::string const full = prefix + std::string(constant.key);
    bool const given = (spec.*constant.value).has_value();
    if (constant.belongs[kind] && !given && !source.has_problem(full))
      source.report_key(full, {}, fmt::format("is missing: {} needs it", name));
    if (!constant.belongs[kind] && source.has(full))
      source.report_value(full, fmt::format("does not belong to strength.kind = \"{}\"", name));
  }
  double const floor = floor_of(material.eos);
  if (material.tension == TensionEnd::spall && !(std::isfinite(floor) && floor < 0.0))
    source.report_value(
        key + "tension", "needs a least pressure below zero, where it parts",
        "give least_pressure, of eos mie_grueneisen, us_up, linear or p_alpha, or tension = "
        "\"floor\"");
  if (spec.kind != StrengthKind::none && material.burn.kind == BurnKind::programmed)
    source.report_value(prefix + "kind", "is given for an explosive that burns",
                        "leave it out: products are a gas");
}

void add_strength_warnings(Case const& c, std::vector<InputProblem>& warnings) {
  for (MaterialSpec const& material : c.materials) {
    if (material.strength.kind == StrengthKind::none) continue;
    add_slope_warning(c, material, warnings);
    double const apex = apex_of(strength_of(material.strength));
    double const floor = floor_of(material.eos);
    if (floor < apex * (1.0 + 1e-3) - 1.0)
      warnings.push_back(problem_of(
          c, "material." + material.name + ".least_pressure",
          fmt::format("lets the material bear a tension of {:.4g} Pa, beyond the apex of its yield "
                      "surface at {:.4g} Pa",
                      -floor, -apex),
          fmt::format("give least_pressure = {:.6g}", apex)));
  }
}

Strength strength_of(StrengthSpec const& spec) {
  auto const value = [](std::optional<double> const& given) { return given.value_or(0.0); };
  double const g = value(spec.shear_modulus);
  switch (spec.kind) {
    case StrengthKind::none:
      return NoStrength{};
    case StrengthKind::elastic:
      return Elastic{g};
    case StrengthKind::von_mises:
      return VonMises{g, value(spec.yield_strength)};
    case StrengthKind::drucker_prager:
      return DruckerPrager{g, value(spec.yield_slope), value(spec.shear_strength)};
    case StrengthKind::mohr_coulomb:
      return MohrCoulomb{g, value(spec.friction_angle), value(spec.cohesion)};
  }
  return NoStrength{};
}

}  // namespace moraine
