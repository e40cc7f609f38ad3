#include "setup/explain_step.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "setup/check_burn.hpp"
#include "setup/check_strength.hpp"
#include "setup/geometry.hpp"
#include "setup/parameter.hpp"
#include "setup/region_lattice.hpp"
#include "smoothing/viscous_stiffness.hpp"
#include "step/simulation.hpp"
#include "step/simulation_setup.hpp"

namespace moraine {
namespace {

std::string time_step_words(Case const& c) {
  if (c.time.fixed_step > 0.0) return fmt::format("fixed at {:.4g} s", c.time.fixed_step);
  std::string text = fmt::format(
      "{:.3g} h / (c + {:.3g} (alpha c + beta |mu|)), {:.3g} sqrt(h / |a|), h / (2 |v|) with h = "
      "{:.4g} m; the last ends at {:.4g} s",
      c.time.courant, viscous_signal(c.numerics.kernel, c.dimension), c.time.courant,
      c.numerics.smoothing_length(), c.time.end);
  for (auto const& material : c.materials)
    if (material.burn.kind == BurnKind::programmed)
      text += fmt::format("; {:.3g} h / D while {} is left to burn", c.time.courant, material.name);
  if (c.numerics.physical_viscosity != ViscosityForm::off)
    text += fmt::format("; {:.3g} h^2 / nu", viscous_share(c.numerics, c.dimension));
  if (c.numerics.penalty.strength > 0.0)
    text += fmt::format("; {:.3g} sqrt(m / k) of the penalty", c.time.courant);
  if (std::isfinite(c.time.max_step)) text += fmt::format("; at most {:.4g} s", c.time.max_step);
  return text;
}

std::string search_words(Case const& c) {
  std::string text = fmt::format("neighbours within 2 h = {:.4g} m and a skin",
                                 kernel_support * c.numerics.smoothing_length());
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (c.periodic[axis]) text += fmt::format("; periodic along {}", axis_names[axis]);
  for (std::size_t side = 0; side < side_names.size(); ++side)
    if (c.symmetry.planes[side / 2][side % 2])
      text += fmt::format("; symmetry plane {}", side_names[side]);
  auto const lattices = lattices_of_regions(c);
  for (std::size_t i = 0; i < lattices.size(); ++i)
    if (has_own_lattice(c.regions[i]))
      text += fmt::format("; h is {:.3g} spacings of {}, {:.4g} m",
                          c.numerics.smoothing_length() / lattices[i].spacing, c.regions[i].name,
                          lattices[i].spacing);
  return text;
}

std::string density_words(Case const& c) {
  if (c.numerics.density == DensityForm::continuity) return "nothing: density is a state";
  return c.numerics.density == DensityForm::summation
             ? "sum of m_j W_ij over neighbours, the particle itself and walls"
             : "the same divided by the sum of m_j / rho_j W_ij, rho_j the plain sums";
}

std::string option_words(Case const& c) {
  auto const& numerics = c.numerics;
  std::vector<std::string> words;
  if (numerics.physical_viscosity != ViscosityForm::off)
    words.push_back(fmt::format(
        "physical viscosity ({})",
        numerics.physical_viscosity == ViscosityForm::morris ? "Morris" : "Monaghan and Cleary"));
  if (numerics.gradient_correction != GradientCorrection::off)
    words.push_back("corrected gradient of continuity and pressure (Bonet and Lok)");
  if (numerics.density_diffusion > 0.0 && numerics.diffusion == DiffusionForm::gradient)
    words.push_back("gradient of density taken out of the diffusion");
  if (numerics.xsph > 0.0)
    words.push_back(fmt::format("places move with averaged velocities (XSPH, {})", numerics.xsph));
  if (numerics.shifting > 0.0)
    words.push_back(fmt::format("places are shifted (coefficient {})", numerics.shifting));
  if (numerics.penalty.strength > 0.0)
    words.push_back(fmt::format(
        "penalty between materials ({:.4g}, exponents {} and {}, below {})",
        numerics.penalty.strength, numerics.penalty.repulsion, numerics.penalty.attraction,
        numerics.penalty.range == PenaltyRange::spacing ? "one spacing" : "one smoothing length"));
  return words.empty() ? "nothing: the case asks for none"
                       : fmt::format("{}", fmt::join(words, ", "));
}

std::string matter_words(Case const& c) {
  std::string text;
  for (auto const& material : c.materials) {
    text +=
        fmt::format("{}{}: {}", text.empty() ? "" : ", ", material.name, eos_name(material.eos));
    if (material.burn.kind != BurnKind::programmed) continue;
    ProgrammedBurn const law = burn_of(material, c.numerics.spacing).law;
    text += fmt::format(
        " (programmed burn: front at {:.4g} m/s, {:.4g} m wide; p = F p_products with F = max((t - "
        "t_lit) D / width, (1 - rho_0/rho) / (1 - {:.4g})), never falling)",
        law.detonation_velocity, law.width, law.cj_volume);
  }
  return text;
}

std::string stress_words(Case const& c) {
  std::string text;
  for (auto const& material : c.materials)
    if (material.strength.kind != StrengthKind::none)
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", material.name,
                          strength_name(strength_of(material.strength)));
  return text.empty() ? "nothing: no material has a strength" : text;
}

std::string wall_words(Case const& c) {
  if (c.walls.empty()) return "nothing: the case has no walls";
  std::string text;
  for (auto const& wall : c.walls) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", wall.name,
                        wall.slip == Slip::free ? "free slip" : "no slip");
    if (wall.mirrors()) text += ", mirror images of the fluid";
    if (wall.pushes())
      text += fmt::format(", repulsive particles (D = {:.4g} m^2/s^2, r0 = {:.4g} m)",
                          wall.repulsion.value_or(0.0),
                          wall.repulsion_range.value_or(0.5 * c.numerics.spacing));
  }
  return text;
}

std::string smoothing_words(Case const& c) {
  Smoothing const& smoothing = c.numerics.smoothing;
  if (!smoothing.varies()) return "";
  return fmt::format("smoothing lengths by {}, between {:.4g} and {:.4g} m",
                     smoothing.mode == SmoothingMode::rate ? "the rate of density" : "density",
                     c.numerics.least_smoothing_length(), c.numerics.largest_smoothing_length());
}

std::string motion_words(Case const& c) {
  std::string text;
  for (auto const& wall : c.walls)
    if (wall.motion.given()) text += fmt::format("{}{}", text.empty() ? "" : ", ", wall.name);
  return text.empty() ? "nothing: all walls are at rest" : text;
}

std::string pair_words(Case const& c) {
  auto const& numerics = c.numerics;
  std::string text = fmt::format(
      "kernel {}, {} precision: density rate ({} form), pressure ({} form) with compatible energy",
      info(numerics.kernel).words, numerics.precision == Precision::mixed ? "mixed" : "double",
      numerics.continuity == ContinuityForm::mass ? "mass" : "volume",
      numerics.momentum == MomentumForm::conservative ? "conservative" : "mixed");
  if (numerics.viscosity_alpha > 0.0 || numerics.viscosity_beta > 0.0)
    text += fmt::format(", artificial viscosity (alpha {}, beta {})", numerics.viscosity_alpha,
                        numerics.viscosity_beta);
  if (numerics.density_diffusion > 0.0)
    text += fmt::format(", density diffusion ({})", numerics.density_diffusion);
  return text;
}

std::string kick_words(Case const& c) {
  if (length(c.gravity) == 0.0) return "no gravity";
  std::string text = "gravity (";
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis)
    text += fmt::format("{}{:.4g}", axis == 0 ? "" : ", ", c.gravity[axis]);
  return text + ") m/s^2";
}

std::string guard_words(Case const& c) {
  std::string text = fmt::format("every {} steps", c.guards.interval);
  for (std::size_t k = 0; k < c.guards.off.size(); ++k)
    text += fmt::format("{}{}", k == 0 ? "; off: " : ", ", c.guards.off[k]);
  return text;
}

struct Words {
  std::string_view label;
  std::string (*text)(Case const&);
};

// By label of the action; an action without an entry is told by its description alone.
constexpr std::array<Words, 12> case_words{{
    {"time step", time_step_words},
    {"kick and drift", smoothing_words},
    {"move walls", motion_words},
    {"search", search_words},
    {"density", density_words},
    {"matter", matter_words},
    {"stress", stress_words},
    {"walls", wall_words},
    {"pairs", pair_words},
    {"optional terms", option_words},
    {"kick and check", kick_words},
    {"guards", guard_words},
}};

}  // namespace

std::string explain_step(Case const& c) {
  std::string text = fmt::format("a time step of {}\n", c.title.empty() ? c.file : c.title);
  if (!c.start.run.empty())
    text += fmt::format("starts from {} of {}, time {:.6g} s, step {}\n", c.start.info.checkpoint,
                        c.start.info.run, c.start.info.time, c.start.info.step);
  int number = 0;
  for (auto const& [label, description] : Simulation::actions()) {
    text += fmt::format("{}. {}: {}\n", ++number, label, description);
    for (auto const& words : case_words)
      if (std::string const told = words.label == label ? words.text(c) : ""; !told.empty())
        text += fmt::format("   {}\n", told);
  }
  return text;
}

}  // namespace moraine
