#include "terms/options/option_backend.hpp"

namespace moraine {

template <int D, Flavour flavour>
std::unique_ptr<OptionBackend> make_options(SweepParameters const& sweep,
                                            OptionParameters const& options, OptionMatter matter);

void OptionOutcome::add(OptionOutcome const& other) {
  if (!std::isnan(viscous_rate) && !(other.viscous_rate <= viscous_rate)) {
    viscous_rate = other.viscous_rate;
    viscous_particle = other.viscous_particle;
  }
  if (!std::isnan(penalty_rate) && !(other.penalty_rate <= penalty_rate)) {
    penalty_rate = other.penalty_rate;
    penalty_particle = other.penalty_particle;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) wall_force[axis] += other.wall_force[axis];
  wall_power += other.wall_power;
  penalty_energy += other.penalty_energy;
  energy.viscosity += other.energy.viscosity;
  energy.wall_viscosity += other.energy.wall_viscosity;
  energy.diffusion += other.energy.diffusion;
}

std::unique_ptr<OptionBackend> make_option_backend(int dimension, Flavour flavour,
                                                   SweepParameters const& sweep,
                                                   OptionParameters const& options,
                                                   OptionMatter matter) {
  bool const mixed = flavour == Flavour::mixed;
  auto const with = [&]<int D>(std::integral_constant<int, D>) {
    return mixed ? make_options<D, Flavour::mixed>(sweep, options, std::move(matter))
                 : make_options<D, Flavour::full>(sweep, options, std::move(matter));
  };
  if (dimension == 1) return with(std::integral_constant<int, 1>{});
  if (dimension == 2) return with(std::integral_constant<int, 2>{});
  return with(std::integral_constant<int, 3>{});
}

}  // namespace moraine
