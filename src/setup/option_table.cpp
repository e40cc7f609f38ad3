#include "setup/option_table.hpp"

namespace moraine {
namespace {

constexpr auto numerics = &Case::numerics;
constexpr auto penalty = &Numerics::penalty;

void add_density(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, numerics, &Numerics::density>(
      {.key = "numerics.density",
       .type = ValueType::choice,
       .preset = static_cast<int>(DensityForm::continuity),
       .names = {"continuity", "summation", "normalised"},
       .meaning = "density as a state that the continuity equation advances, or summed over "
                  "neighbours in each step, as it is or divided by the sum of their volumes",
       .source = "Monaghan (1992); Chen, Beraun and Carney (1999)"}));
  table.push_back(member<Case, numerics, &Numerics::diffusion>(
      {.key = "numerics.density_diffusion_form",
       .type = ValueType::choice,
       .preset = static_cast<int>(DiffusionForm::hydrostatic),
       .names = {"hydrostatic", "gradient"},
       .meaning = "what density diffusion leaves alone: the gradient of hydrostatic equilibrium, "
                  "or any smooth one (delta-SPH)",
       .source = "Fourtakas et al. (2019), eq. 9; Antuono et al. (2010)"}));
}

void add_motion(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, numerics, &Numerics::physical_viscosity>(
      {.key = "numerics.physical_viscosity",
       .type = ValueType::choice,
       .preset = static_cast<int>(ViscosityForm::off),
       .names = {"none", "morris", "monaghan_cleary"},
       .meaning = "form of the viscosity of Newtonian fluids, with material.dynamic_viscosity",
       .source = "Morris, Fox and Zhu (1997), eq. 22; Cleary (1998), Monaghan (2005)"}));
  table.push_back(member<Case, numerics, &Numerics::xsph>(
      {.key = "numerics.xsph",
       .preset = 0.0,
       .limits = Limits::between(0.0, 1.0),
       .meaning = "XSPH: share of the mean velocity of neighbours in the motion of places; 0.5 is "
                  "usual, 0: none",
       .source = "Monaghan, J. Comput. Phys. 82 (1989) 1"}));
  table.push_back(member<Case, numerics, &Numerics::shifting>(
      {.key = "numerics.shifting",
       .preset = 0.0,
       .limits = Limits::between(0.0, 100.0),
       .meaning = "coefficient of the shifting of particles to where they are fewer, away from "
                  "free surfaces; 20 to 40 is usual, 0: none",
       .source = "Lind et al. (2012); Skillen et al. (2013)"}));
  table.push_back(member<Case, numerics, &Numerics::gradient_correction>(
      {.key = "numerics.gradient_correction",
       .type = ValueType::choice,
       .preset = static_cast<int>(GradientCorrection::off),
       .names = {"none", "bonet_lok"},
       .meaning = "correction of the kernel gradient in continuity and pressure force",
       .source = "Bonet and Lok, Comput. Methods Appl. Mech. Eng. 180 (1999) 97"}));
}

void add_artificial_stress(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, numerics, &Numerics::artificial_stress>(
      {.key = "numerics.artificial_stress",
       .preset = 0.0,
       .limits = Limits::between(0.0, 1.0),
       .meaning = "share of the tension of a solid that holds close particles apart, so that they "
                  "do not clump; 0.3 is usual for cohesive solids, 0: none",
       .source = "Gray, Monaghan and Swift (2001), eqs 27 to 34"}));
}

void add_penalty(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, numerics, penalty, &PenaltySpec::strength>(
      {.key = "numerics.penalty.strength",
       .preset = 0.0,
       .limits = Limits::not_negative(),
       .meaning = "strength of the repulsion between particles of materials of different "
                  "material.penalty_group, in N in 2D, J in 3D, Pa m in 1D; 0: none",
       .source = "1e5 is usual for blast; Liu and Liu (2003), chapter 6"}));
  table.push_back(member<Case, numerics, penalty, &PenaltySpec::range>(
      {.key = "numerics.penalty.range",
       .type = ValueType::choice,
       .preset = static_cast<int>(PenaltyRange::spacing),
       .names = {"spacing", "smoothing_length"},
       .meaning = "distance below which the repulsion acts; smoothing_length is the source's, and "
                  "pushes at rest wherever it is more than a spacing"}));
  table.push_back(member<Case, numerics, penalty, &PenaltySpec::repulsion>(
      {.key = "numerics.penalty.repulsion",
       .type = ValueType::integer,
       .preset = 12,
       .limits = Limits::between(2.0, 24.0),
       .meaning = "exponent of the repulsive part; larger than that of the attractive part"}));
  table.push_back(member<Case, numerics, penalty, &PenaltySpec::attraction>(
      {.key = "numerics.penalty.attraction",
       .type = ValueType::integer,
       .preset = 6,
       .limits = Limits::between(1.0, 23.0),
       .meaning = "exponent of the attractive part"}));
}

}  // namespace

void add_options(std::vector<Entry<Case>>& table) {
  add_density(table);
  add_motion(table);
  add_artificial_stress(table);
  add_penalty(table);
}

}  // namespace moraine
