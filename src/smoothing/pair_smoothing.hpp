// The smoothing length of a pair of particles whose own ones differ.
#pragma once

#include "base/macros.hpp"
#include "base/simd.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {

/// h_ij [m], the same seen from i and from j, so that pairs conserve momentum and energy.
///
///   arithmetic: (h_i + h_j) / 2,  geometric: sqrt(h_i h_j),  largest, smallest of the two
///
/// Source: Liu & Liu, Smoothed Particle Hydrodynamics (2003), section 4.4.4; Hernquist & Katz,
/// Astrophys. J. Suppl. 70 (1989) 419, eq. 2.16 (arithmetic).
template <class Real>
MORAINE_FORMULA Real pair_smoothing(PairSmoothing of_pair, Real const& h_i, Real const& h_j) {
  switch (of_pair) {  // the same for all pairs: a jump that is always guessed right
    case PairSmoothing::geometric:
      return square_root(h_i * h_j);
    case PairSmoothing::largest:
      return maximum(h_i, h_j);
    case PairSmoothing::smallest:
      return minimum(h_i, h_j);
    default:
      return number<Real>(0.5) * (h_i + h_j);
  }
}

}  // namespace moraine
