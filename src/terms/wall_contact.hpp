#pragma once

#include "terms/pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Keeps particles from crossing a wall's face.
///
///   S_ij = c_i^2 / rho_ij min(2, max(0, 1 - gap_i / gap_0)),   gap_0 = a quarter of the finest
///   spacing
///
/// gap_i is the distance of particle i in front of the face of wall particle j; a first row lies
/// half a spacing in front. Why it is needed: density by continuity remembers volume. A sheet of
/// water one particle thin that goes on stretching sinks towards the wall to keep its density, and
/// would pass through it. The term has the stiffness of the material itself, so the time-step vote
/// on sound covers it; its work goes to the particle's energy and comes back, so the sum of
/// energies does not change. It is zero for gaps above gap_0: material compressed more than twofold
/// along the normal comes that near and is pushed harder than its pressure says. Own choice: the
/// repulsion by distance of Monaghan, J. Comput. Phys. 110 (1994) 399, section 4, pushes at rest
/// and varies along the wall. Wall particles behind edges and corners have no face: gap_i is the
/// distance to the ball about them that reaches to the faces, and is nothing but solid.
template <class Real>
struct WallContact {
  Real inverse_gap;  // 1 / gap_0 [1/m]

  template <int D, class Self, class Neighbour>
  MORAINE_FORMULA void operator()(Pair<Real, D> const& pair, Self const& i, Neighbour const&,
                                  PairRates<Real>& rates) const {
    Real const c = sound_speed(i);
    Real const overlap = maximum(number<Real>(1) - pair.gap * inverse_gap, number<Real>(0));
    rates.stress += c * c * minimum(overlap, number<Real>(2)) / pair.mean_density;
  }
};

}  // namespace moraine
