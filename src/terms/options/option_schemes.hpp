// Records of the optional terms.
#pragma once

#include "terms/pair_fields.hpp"
#include "terms/sweep_parameters.hpp"

namespace moraine {

/// What terms without gradients of neighbours read.
template <int D>
struct PlainOptions {
  using Fluid =
      RecordLayout<D, PairField::velocity, PairField::compression, PairField::reference_density,
                   PairField::mass, PairField::sound_speed, PairField::smoothing_length,
                   PairField::dynamic_viscosity, PairField::group>;
  /// The density of a wall particle is its reference density; `velocity` is what viscosity sees.
  using Wall =
      RecordLayout<D, PairField::velocity, PairField::wall_velocity, PairField::reference_density,
                   PairField::pressure_term, PairField::normal, PairField::wall_depth>;
};

/// The same with corrected gradients.
template <int D>
struct GradientOptions {
  using Fluid =
      RecordLayout<D, PairField::velocity, PairField::compression, PairField::reference_density,
                   PairField::mass, PairField::sound_speed, PairField::smoothing_length,
                   PairField::dynamic_viscosity, PairField::group, PairField::pressure_term,
                   PairField::density_gradient, PairField::correction>;
  using Wall = typename PlainOptions<D>::Wall;
};

/// Fields that are the same for all, as numbers of a record: a wall particle's density is that of
/// its record.
template <class Slot>
UniformFields<Slot> option_uniform(SweepParameters const& sweep) {
  auto uniform = sweep.template uniform_as<Slot>();
  uniform[static_cast<std::size_t>(PairField::compression)] = Slot(0);
  return uniform;
}

}  // namespace moraine
