// Layers along the ends of a body in which waves die out instead of being reflected.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace moraine {

/// Absorbing layers at chosen ends of the axes, all of one thickness.
///
///   dv/dt = ... - a v,   drho/dt = ... - a (rho - rho_rest),   ds/dt = ... - a s
///   a(x) = a_max (depth / thickness)^2,   a_max = 3 c ln(1 / R) / (2 thickness)
///
/// Velocity and stress fade alike, so that the impedance is the same all through the layer and a
/// wave that comes straight on is not reflected where it begins; the square keeps what discrete
/// particles reflect small. R is the share of the amplitude that comes back after the way through
/// the layer, a reflection at its end, and the way out. Source: a perfectly matched layer for
/// normal incidence, Berenger, J. Comput. Phys. 114 (1994) 185; Israeli & Orszag, J. Comput. Phys.
/// 41 (1981) 115. Waves that come on at a slant are reflected in part; slow ones (shear) fade
/// sooner. c: speed of sound of the material in its reference state [m/s].
struct AbsorbingLayers {
  /// Where the layers end, [axis][0: minus, 1: plus] [m]; none: the end reflects as it does.
  std::array<std::array<std::optional<double>, 2>, 3> ends{};
  double thickness = 0.0;    // m
  double reflection = 1e-3;  // R

  bool any() const { return thickness > 0.0; }

  /// a / c at a place [1/m]; zero outside of all layers. The layers of corners add up.
  template <class Place>
  double fading(Place const& place) const {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t end = 0; end < 2; ++end) {
        if (!ends[axis][end]) continue;
        double const outwards = end == 0 ? -1.0 : 1.0;
        double const depth = thickness + outwards * (place[axis] - *ends[axis][end]);
        if (depth > 0.0) sum += (depth / thickness) * (depth / thickness);
      }
    return sum * 1.5 * std::log(1.0 / reflection) / thickness;
  }
};

}  // namespace moraine
