#include "setup/check_options.hpp"

#include <algorithm>
#include <utility>

namespace moraine {
namespace {

bool any_viscosity(Case const& c) {
  return std::any_of(c.materials.begin(), c.materials.end(),
                     [](MaterialSpec const& m) { return m.dynamic_viscosity > 0.0; });
}

bool keeps_apart(Case const& c) {
  return std::any_of(c.materials.begin(), c.materials.end(), [&](MaterialSpec const& m) {
    return m.group() != c.materials.front().group();
  });
}

/// The velocity that the correction sees of a wall with free slip is that of its dummies, not of
/// the place beside the fluid: the main sweep tells them apart where a wall turns.
void check_turning_walls(Case const& c, Source& source) {
  std::string const key = "numerics.gradient_correction";
  if (c.numerics.gradient_correction == GradientCorrection::off || !source.good(key)) return;
  for (WallSpec const& wall : c.walls)
    if (wall.motion.motion && wall.motion.motion->rotation.given())
      return source.report_value(key, "knows no walls that turn, as " + wall.name + " does",
                                 "leave it out");
}

}  // namespace

void check_options(Case const& c, Source& source) {
  check_turning_walls(c, source);
  Numerics const& n = c.numerics;
  std::string const viscosity = "numerics.physical_viscosity";
  if (n.physical_viscosity != ViscosityForm::off && source.good(viscosity) && !any_viscosity(c))
    source.report_value(viscosity, "needs a material that has one",
                        "give material.NAME.dynamic_viscosity");
  if (n.penalty.attraction < n.penalty.repulsion) return;
  for (auto const* key : {"numerics.penalty.attraction", "numerics.penalty.repulsion"})
    if (source.good(key))
      return source.report_value(
          key, "makes particles attract each other",
          "the exponent of the repulsion is larger than that of the attraction");
}

void add_option_warnings(Case const& c, std::vector<InputProblem>& warnings) {
  Numerics const& n = c.numerics;
  auto const warn = [&](std::string const& key, std::string rule, std::string hint = {}) {
    warnings.push_back(problem_of(c, key, std::move(rule), std::move(hint)));
  };
  if (n.physical_viscosity == ViscosityForm::off)
    for (MaterialSpec const& material : c.materials)
      if (material.dynamic_viscosity > 0.0)
        warn("material." + material.name + ".dynamic_viscosity", "counts for nothing",
             "give numerics.physical_viscosity");
  if (n.penalty.strength > 0.0 && !keeps_apart(c))
    warn("numerics.penalty.strength",
         c.materials.size() == 1 ? "keeps nothing apart: the case has one material"
                                 : "keeps nothing apart: all materials are of one penalty_group");
  if (n.penalty.strength > 0.0 && n.penalty.range == PenaltyRange::smoothing_length &&
      n.smoothing_factor > 1.0)
    warn("numerics.penalty.range", "pushes materials apart that are at rest on their lattice",
         "take \"spacing\"");
  if (n.diffusion == DiffusionForm::gradient && !(n.density_diffusion > 0.0))
    warn("numerics.density_diffusion_form", "counts for nothing",
         "give numerics.density_diffusion, 0.1 is usual");
  if (n.density != DensityForm::continuity && n.density_diffusion > 0.0)
    warn("numerics.density_diffusion", "counts for nothing where density is a sum over neighbours");
  if (n.density != DensityForm::continuity && c.materials.size() > 1)
    warn("numerics.density", "blurs the jump of density between materials over a support",
         "take \"continuity\" with numerics.continuity = \"volume\"");
  bool const corrected = n.gradient_correction != GradientCorrection::off;
  if (corrected && n.shifting == 0.0)
    warn("numerics.gradient_correction", "blows up by itself where motion lasts",
         "give numerics.shifting, 20 is usual");
  for (MaterialSpec const& material : c.materials)
    if (std::holds_alternative<Jwl>(material.eos) && corrected)
      warn("numerics.gradient_correction",
           "is for flows that stay together; " + material.name + " expands into a spray");
}

}  // namespace moraine
