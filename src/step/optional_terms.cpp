// Density by summation and the optional terms of a step.
#include "step/simulation.hpp"
#include "step/simulation_setup.hpp"

namespace moraine {
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
    vote = {viscous_share(model_.numerics, model_.dimension) / option_outcome_.viscous_rate,
            viscous_limit, id[option_outcome_.viscous_particle]};
  if (option_outcome_.penalty_rate > 0.0)
    vote = stricter(vote, {model_.time.courant / std::sqrt(option_outcome_.penalty_rate),
                           penalty_limit, id[option_outcome_.penalty_particle]});
  return vote;
}

void Simulation::loads_on_walls(std::vector<WallLoad>& loads) const {
  pairs_->loads_on_walls(model_.particles, search_, loads);
  if (options_) options_->add_loads_on_walls(model_.particles, search_, loads);
  if (strength_) strength_->add_loads_on_walls(model_.particles, search_, loads);
}

void Simulation::loads_on_mirrors(std::vector<MirrorLoad>& loads) const {
  pairs_->loads_on_mirrors(model_.particles, search_, loads);
  if (options_) options_->add_loads_on_mirrors(model_.particles, search_, loads);
  if (strength_) strength_->add_loads_on_mirrors(model_.particles, search_, loads);
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
