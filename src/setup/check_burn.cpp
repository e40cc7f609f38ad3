#include "setup/check_burn.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "exact/detonation.hpp"
#include "setup/geometry.hpp"

namespace moraine {
namespace {

Detonation detonation_of(Eos const& eos) {
  return chapman_jouguet({eos, reference_density(eos), reference_energy(eos)});
}

/// The Chapman-Jouguet state where the spec does not say both of its values.
void resolve(MaterialSpec& material) {
  BurnSpec& burn = material.burn;
  auto const* const jwl = std::get_if<Jwl>(&material.eos);
  if (!burn.detonation_velocity && jwl != nullptr)
    burn.detonation_velocity = jwl->detonation_velocity;
  if (burn.detonation_velocity && burn.cj_volume) return;
  Detonation const cj = detonation_of(material.eos);
  if (!burn.detonation_velocity) burn.detonation_velocity = cj.speed;
  if (!burn.cj_volume) burn.cj_volume = reference_density(material.eos) / cj.behind.density;
}

}  // namespace

void check_burn(MaterialSpec& material, std::string const& key, Source& source) {
  BurnSpec const& burn = material.burn;
  if (burn.kind != BurnKind::programmed) return;
  std::string const kind = key + "burn.kind";
  if (source.has_problem(key + "eos") || source.has_problem(key + "use")) return;
  if (!can_burn(material.eos)) {
    source.report_value(kind, "needs products of an explosive, eos = \"jwl\" or \"ideal_gas\"");
    return;
  }
  bool const tried = source.has(key + "burn.ignition_points") ||
                     source.has_problem(key + "burn.ignition_points") || burn.line_from ||
                     burn.line_to || burn.plane_point || burn.plane_normal ||
                     source.has_problem(key + "burn.ignition_line.from") ||
                     source.has_problem(key + "burn.ignition_plane.point");
  if (!tried)
    source.report_value(kind, "needs a place where the charge is lit",
                        "give burn.ignition_points, burn.ignition_line or burn.ignition_plane");
  if (source.good(key + "burn.ignition_points") && burn.ignition_points.empty())
    source.report_value(key + "burn.ignition_points", "holds no point");
  if (burn.plane_normal && !(length(*burn.plane_normal) > 0.0))
    source.report_value(key + "burn.ignition_plane.normal", "has no length");
  try {
    resolve(material);
  } catch (std::logic_error const&) {  // std::domain_error and std::invalid_argument are of it
    source.report_value(kind, "finds no Chapman-Jouguet state for the constants of the material",
                        "give burn.cj_volume and burn.detonation_velocity");
  }
}

void add_burn_warnings(Case const& c, std::vector<InputProblem>& warnings) {
  constexpr double usual = 0.03;  // of constants that are fitted to a measured speed
  for (MaterialSpec const& material : c.materials) {
    BurnSpec const& burn = material.burn;
    if (burn.kind != BurnKind::programmed || !burn.detonation_velocity) continue;
    try {
      double const own = detonation_of(material.eos).speed;
      double const given = *burn.detonation_velocity;
      if (std::abs(given / own - 1.0) > usual)
        warnings.push_back(problem_of(
            c, "material." + material.name + ".burn.detonation_velocity",
            fmt::format("makes the front run at {:.4g} m/s; products with these constants drive a "
                        "detonation at {:.4g} m/s",
                        given, own)));
    } catch (std::logic_error const&) {  // no such state: there is nothing to compare with
    }
  }
}

Burn burn_of(MaterialSpec const& material, double spacing) {
  MaterialSpec known = material;
  resolve(known);
  BurnSpec const& spec = known.burn;
  Burn burn;
  burn.law = {*spec.detonation_velocity, *spec.cj_volume, spec.width_in_spacings * spacing,
              reference_density(material.eos)};
  burn.ignition.points = spec.ignition_points;
  burn.ignition.delay = spec.delay;
  if (spec.line_from && spec.line_to)
    burn.ignition.line = Ignition::Line{*spec.line_from, *spec.line_to};
  if (spec.plane_point && spec.plane_normal)
    burn.ignition.plane = Ignition::Plane{*spec.plane_point, *spec.plane_normal};
  return burn;
}

}  // namespace moraine
