// Smoothing lengths of the particles of a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "step/model.hpp"

namespace moraine {

/// h of fluid particles [m]: one for all, or their own.
struct SmoothingLengths {
  std::span<double const> own;  // empty: all have that of the case
  double of_case = 0.0;

  explicit SmoothingLengths(Model const& model)
      : own(model.particles.scalar(Field::smoothing_length)),
        of_case(model.numerics.smoothing_length()) {}
  double operator()(std::size_t i) const { return own.empty() ? of_case : own[i]; }
};

/// How many particles had their smoothing length cut off, the most at any time so far.
struct SmoothingClips {
  std::uint64_t at_least = 0;
  std::uint64_t at_most = 0;
};

/// The smoothing length [m] that belongs to a density,
///
///   h = f (m / rho)^(1/d),   f: smoothing_factor,
///
/// so that a lattice at any density has h of f spacings; not cut off. Source: Price, J. Comput.
/// Phys. 231 (2012) 759, eq. 10. mass in kg (per m in 2D, per m^2 in 1D), density in kg/m^3.
double smoothing_of_density(Model const& model, double mass, double density);

}  // namespace moraine
