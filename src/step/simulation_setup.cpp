#include "step/simulation_setup.hpp"

#include <algorithm>
#include <cmath>

#include "smoothing/viscous_stiffness.hpp"

namespace moraine {

SearchSettings search_settings(Model const& model) {
  SearchSettings settings;
  settings.dimension = model.dimension;
  settings.support = kernel_support * model.numerics.smoothing_length();
  Smoothing const& smoothing = model.numerics.smoothing;
  if (smoothing.varies()) settings.supports = kernel_support;
  settings.larger_of_two = smoothing.of_pair == PairSmoothing::largest;
  settings.walls_move = model.walls.move();
  // Wall particles and images lie up to a list radius outside of the domain.
  double const margin = 2.0 * kernel_support * model.numerics.largest_smoothing_length();
  auto low = model.domain_min;
  auto high = model.domain_max;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(model.dimension); ++axis) {
    low[axis] -= margin;
    high[axis] += margin;
  }
  settings.fixed_point = FixedPoint::over(low, high, model.dimension);
  DomainSides& sides = settings.sides;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(model.dimension); ++axis) {
    sides.periodic[axis] = model.periodic[axis];
    sides.low[axis] = model.domain_min[axis];
    for (std::size_t end = 0; end < 2; ++end) sides.planes[axis][end] = model.plane(axis, end);
    sides.length[axis] = model.domain_max[axis] - model.domain_min[axis];
    sides.length_units[axis] = std::llround(sides.length[axis] / settings.fixed_point.scale);
    sides.low_units[axis] =
        settings.fixed_point.units(model.domain_min[axis], static_cast<int>(axis));
  }
  return settings;
}

SweepParameters sweep_parameters(Model const& model) {
  SweepParameters p;
  Eos const& eos = model.materials.front().eos;
  p.walls_move = model.walls.move();
  for (std::size_t side = 0; side < 6; ++side) {
    Plane const plane = model.mirror_walls[side / 2][side % 2];
    p.mirror_walls = p.mirror_walls || plane != Plane::open;
    // Images with pressures or velocities of their own are no mirror images of a pair any more.
    p.walls_keep_work = p.walls_keep_work || plane == Plane::stick_wall ||
                        (plane != Plane::open && model.gravity[side / 2] != 0.0);
  }
  double const rho = reference_density(eos);
  double const c =
      std::visit([&](auto const& law) { return law.sound_speed(rho, law.reference_energy); }, eos);
  p.kernel = model.numerics.kernel;
  p.smoothing_length = model.numerics.smoothing_length();
  p.of_pair = model.numerics.smoothing.of_pair;
  p.viscosity_alpha = model.numerics.viscosity_alpha;
  p.viscosity_beta = model.numerics.viscosity_beta;
  p.viscous_signal = viscous_signal(model.numerics.kernel, model.dimension);
  p.density_diffusion = model.numerics.density_diffusion;
  p.gravity = model.gravity;
  for (std::size_t axis = 0; axis < 3; ++axis) p.image_slope[axis] = model.gravity[axis] / (c * c);
  if (model.numerics.diffusion == DiffusionForm::hydrostatic) p.hydrostatic_slope = p.image_slope;
  p.volume_continuity = model.numerics.continuity == ContinuityForm::volume;
  p.summed_density = model.numerics.density != DensityForm::continuity;
  p.mixed_momentum = model.numerics.momentum == MomentumForm::mixed;
  // The first row of the finest particles must stand free of it.
  double const finest = model.finest_spacing > 0.0 ? model.finest_spacing : model.numerics.spacing;
  p.contact_gap = 0.25 * std::min(finest, model.numerics.spacing);
  double const lattice_volume = std::pow(model.numerics.spacing, model.dimension);
  auto const set = [&](PairField field, double value) {
    p.uniform[static_cast<std::size_t>(field)] = value;
  };
  set(PairField::mass, rho * lattice_volume);
  set(PairField::reference_density, rho);
  set(PairField::sound_speed, c);
  set(PairField::lattice_volume, lattice_volume);
  return p;
}

std::vector<double> reference_densities(Model const& model) {
  std::vector<double> densities;
  for (Material const& material : model.materials)
    densities.push_back(reference_density(material.eos));
  return densities;
}

OptionParameters option_parameters(Model const& model) {
  Numerics const& numerics = model.numerics;
  OptionParameters p;
  p.viscosity = numerics.physical_viscosity;
  p.xsph = numerics.xsph;
  if (numerics.diffusion == DiffusionForm::gradient)
    p.gradient_diffusion = numerics.density_diffusion;
  p.corrected_gradient = numerics.gradient_correction != GradientCorrection::off;
  p.shifting = numerics.shifting;
  p.penalty_strength = numerics.penalty.strength;
  // At r = spacing while both have the h of the case, or at their mean h.
  p.penalty_range =
      numerics.penalty.range == PenaltyRange::spacing ? 0.5 / numerics.smoothing_factor : 0.5;
  p.penalty_repulsion = numerics.penalty.repulsion;
  p.penalty_attraction = numerics.penalty.attraction;
  return p;
}

namespace {

/// The number of a group is that of its first material.
std::vector<int> penalty_groups(Model const& model) {
  auto const& all = model.materials;
  std::vector<int> groups;
  for (Material const& material : all) {
    auto const of_group = [&](Material const& m) {
      return m.penalty_group == material.penalty_group;
    };
    groups.push_back(
        static_cast<int>(std::find_if(all.begin(), all.end(), of_group) - all.begin()));
  }
  return groups;
}

}  // namespace

std::unique_ptr<OptionBackend> make_options_of(Model const& model) {
  OptionParameters const options = option_parameters(model);
  SweepParameters const sweep = sweep_parameters(model);
  if (!options.any() && !sweep.summed_density) return nullptr;
  OptionMatter matter{reference_densities(model), {}, penalty_groups(model)};
  for (Material const& material : model.materials)
    matter.dynamic_viscosity.push_back(material.dynamic_viscosity);
  return make_option_backend(model.dimension, model.flavour(), sweep, options, std::move(matter));
}

std::unique_ptr<StrengthBackend> make_strength_of(Model const& model) {
  if (!model.has_solids()) return nullptr;
  StrengthMatter matter{reference_densities(model),
                        {},
                        model.numerics.artificial_stress,
                        model.numerics.smoothing_factor};
  for (Material const& material : model.materials)
    matter.solid.push_back(is_solid(material.strength) ? 1 : 0);
  return make_strength_backend(model.dimension, model.flavour(), sweep_parameters(model),
                               std::move(matter));
}

double viscous_share(Numerics const& numerics, int dimension) {
  double const stiffness = 2.0 * dimension * viscous_stiffness(numerics.kernel, dimension);
  bool const central = numerics.physical_viscosity == ViscosityForm::monaghan_cleary;
  return 0.6 / (central ? 3.0 * stiffness : stiffness);
}

SchemeName scheme_of(Model const& model) {
  if (model.numerics.smoothing.varies()) return SchemeName::variable;
  if (model.numerics.continuity == ContinuityForm::volume) return SchemeName::compressible;
  if (model.numerics.momentum == MomentumForm::mixed) return SchemeName::compressible;
  if (model.walls.turn()) return SchemeName::compressible;
  if (model.materials.size() != 1 || !std::holds_alternative<Tait>(model.materials.front().eos))
    return SchemeName::compressible;
  double const lattice_mass =
      sweep_parameters(model).uniform[static_cast<std::size_t>(PairField::mass)];
  for (double const mass : model.particles.scalar(Field::mass))
    if (std::fabs(mass - lattice_mass) > 1e-12 * lattice_mass) return SchemeName::compressible;
  return SchemeName::liquid;
}

}  // namespace moraine
