// Density by summation and the optional terms of a step.
#include "smoothing/viscous_stiffness.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

/// Step that physical viscosity bears, in h^2 / nu: 0.6 / (2 d K), the time in which a particle
/// comes to rest among its neighbours, K of smoothing/viscous_stiffness.hpp; a third of it for the
/// form along x_ij, which wears down compression three times as fast as shear. The predictor is
/// stable below 0.71 to 1.4 in place of 0.6: measured in boxes in 1D to 3D, even and disordered, h
/// of 1.2 to 2 spacings, with six kernels. For Wendland C2 in 2D it is 0.092; Morris, Fox & Zhu, J.
/// Comput. Phys. 136 (1997) 214, eq. 31, have 0.125 for the quintic spline, whose h is smaller.
double viscous_share(Model const& model) {
  double const stiffness =
      2.0 * model.dimension * viscous_stiffness(model.numerics.kernel, model.dimension);
  bool const central = model.numerics.physical_viscosity == ViscosityForm::monaghan_cleary;
  return 0.6 / (central ? 3.0 * stiffness : stiffness);
}

}  // namespace

void Simulation::sum_densities() {
  if (density_is_state()) return;
  options_->sum_densities(model_.particles, search_, model_.walls,
                          model_.numerics.density == DensityForm::normalised);
}

void Simulation::sum_optional_terms() {
  if (!options_ || !option_parameters_.any()) return;
  option_outcome_ = options_->sweep(model_.particles, search_);
  for (std::size_t axis = 0; axis < 3; ++axis)
    swept_.wall_force[axis] += option_outcome_.wall_force[axis];
  swept_.wall_power += option_outcome_.wall_power;
}

Vote Simulation::vote_of_options() const {
  Vote vote;
  auto const id = model_.particles.id();
  if (option_outcome_.viscous_rate > 0.0)
    vote = {viscous_share(model_) / option_outcome_.viscous_rate, viscous_limit,
            id[option_outcome_.viscous_particle]};
  if (option_outcome_.penalty_rate > 0.0)
    vote = stricter(vote, {model_.time.courant / std::sqrt(option_outcome_.penalty_rate),
                           penalty_limit, id[option_outcome_.penalty_particle]});
  return vote;
}

void Simulation::loads_on_walls(std::vector<WallLoad>& loads) const {
  pairs_->loads_on_walls(model_.particles, search_, loads);
  if (options_) options_->add_loads_on_walls(model_.particles, search_, loads);
}

void Simulation::loads_on_mirrors(std::vector<MirrorLoad>& loads) const {
  pairs_->loads_on_mirrors(model_.particles, search_, loads);
  if (options_) options_->add_loads_on_mirrors(model_.particles, search_, loads);
}

/// Rates are saved with the particles; what else the last sweep told must be there for the next.
void Simulation::exchange_options(Archive& archive) {
  OptionOutcome& told = option_outcome_;
  archive.number("options/viscous_rate", told.viscous_rate);
  archive.number("options/penalty_rate", told.penalty_rate);
  archive.number("options/penalty_energy", told.penalty_energy);
  archive.number("options/viscous_heat", told.energy.viscosity);
  archive.number("options/wall_viscous_heat", told.energy.wall_viscosity);
  archive.number("options/diffusion", told.energy.diffusion);
  for (std::size_t* particle : {&told.viscous_particle, &told.penalty_particle}) {
    std::uint64_t index = *particle;
    archive.number(particle == &told.viscous_particle ? "options/viscous_particle"
                                                      : "options/penalty_particle",
                   index);
    *particle = index;
  }
}

}  // namespace moraine
