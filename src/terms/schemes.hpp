// The sets of pair terms that the sweep is instantiated for, with the records they read.
#pragma once

#include <tuple>

#include "terms/artificial_viscosity.hpp"
#include "terms/continuity_density.hpp"
#include "terms/density_diffusion.hpp"
#include "terms/pair_fields.hpp"
#include "terms/pressure_force.hpp"
#include "terms/sweep_parameters.hpp"
#include "terms/wall_contact.hpp"
#include "terms/wall_pressure.hpp"

namespace moraine {

/// Terms that take energy from motion, or from compression without telling the energy equation.
template <class Real, int D>
auto dissipative_terms(SweepParameters const& p) {
  DensityDiffusion<Real, D> diffusion{number<Real>(2.0 * p.density_diffusion), {}};
  for (int axis = 0; axis < D; ++axis)
    diffusion.hydrostatic_slope[axis] =
        number<Real>(p.hydrostatic_slope[static_cast<std::size_t>(axis)]);
  return std::tuple{
      ArtificialViscosity<Real>{number<Real>(p.viscosity_alpha), number<Real>(p.viscosity_beta)},
      diffusion};
}

/// The same between a fluid particle and a wall: no diffusion, a wall has no density of its own.
template <class Real>
auto dissipative_wall_terms(SweepParameters const& p) {
  return std::tuple{
      ArtificialViscosity<Real>{number<Real>(p.viscosity_alpha), number<Real>(p.viscosity_beta)}};
}

template <class Real>
ContinuityDensity<Real> continuity(SweepParameters const& p) {
  return {number<Real>(p.volume_continuity ? 1.0 : 0.0)};
}

/// Terms between fluid particles, built for a number type from the parameters of a run.
template <class Real, int D>
auto fluid_terms(SweepParameters const& p) {
  return std::tuple_cat(std::tuple{continuity<Real>(p), PressureForce{p.mixed_momentum}},
                        dissipative_terms<Real, D>(p));
}

/// Terms between a fluid particle and a wall.
template <class Real>
auto wall_terms(SweepParameters const& p) {
  return std::tuple_cat(
      std::tuple{continuity<Real>(p), WallPressure{.form = {.mixed = p.mixed_momentum}},
                 WallContact<Real>{number<Real>(1.0 / p.contact_gap)}},
      dissipative_wall_terms<Real>(p));
}

/// One weakly compressible liquid: mass, reference density and sound speed are the same for all
/// particles, so that a record fits two quads in 3D.
template <int D>
struct LiquidScheme {
  static constexpr bool uniform = true;
  using Fluid =
      RecordLayout<D, PairField::velocity, PairField::pressure_term, PairField::compression>;
  using Wall = RecordLayout<D, PairField::velocity, PairField::pressure_term,
                            PairField::compression, PairField::normal, PairField::wall_depth>;
};

/// Any mixture of compressible materials, and walls that turn. The density of a wall particle is
/// its reference density.
template <int D>
struct CompressibleScheme {
  static constexpr bool uniform = false;
  using Fluid =
      RecordLayout<D, PairField::velocity, PairField::pressure_term, PairField::compression,
                   PairField::reference_density, PairField::mass, PairField::sound_speed>;
  using Wall = RecordLayout<D, PairField::velocity, PairField::pressure_term,
                            PairField::reference_density, PairField::sound_speed, PairField::normal,
                            PairField::wall_depth, PairField::wall_turn>;
};

/// The same, where particles have smoothing lengths of their own.
template <int D>
struct VariableScheme {
  static constexpr bool uniform = false;
  using Fluid = RecordLayout<D, PairField::velocity, PairField::pressure_term,
                             PairField::compression, PairField::reference_density, PairField::mass,
                             PairField::sound_speed, PairField::smoothing_length>;
  using Wall = typename CompressibleScheme<D>::Wall;
};

}  // namespace moraine
