// Deviatoric stress: what of a stress is no pressure, and how a plane or a line packs it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/symmetric.hpp"

namespace moraine {

/// Deviatoric stress s = sigma + p 1 with trace zero [Pa], tension positive; always in 3D.
using Deviator = Symmetric<3>;

/// a : b, all nine products.
MORAINE_HD inline double contraction(Symmetric<3> const& a, Symmetric<3> const& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// sqrt(J2) = sqrt(s : s / 2), the shear stress of pure shear [Pa].
MORAINE_HD inline double shear_norm(Deviator const& s) {
  return std::sqrt(0.5 * contraction(s, s));
}

MORAINE_HD inline Symmetric<3> scaled(Symmetric<3> m, double factor) {
  for (double& number : m) number *= factor;
  return m;
}

/// Of what a run in D dimensions keeps: in 2D (plane strain) s_zz = -(s_xx + s_yy), in 1D (uniaxial
/// strain) s_yy = s_zz = -s_xx / 2.
template <int D>
MORAINE_HD Deviator unpacked(Symmetric<D> const& kept) {
  if constexpr (D == 1)
    return {kept[0], -0.5 * kept[0], -0.5 * kept[0], 0.0, 0.0, 0.0};
  else if constexpr (D == 2)
    return {kept[0], kept[1], -(kept[0] + kept[1]), kept[2], 0.0, 0.0};
  else
    return kept;
}

template <int D>
MORAINE_HD Symmetric<D> packed(Deviator const& s) {
  if constexpr (D == 1)
    return {s[0]};
  else if constexpr (D == 2)
    return {s[0], s[1], s[3]};
  else
    return s;
}

}  // namespace moraine
