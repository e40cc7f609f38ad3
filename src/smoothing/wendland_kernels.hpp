// Wendland's kernels of higher smoothness, for many neighbours.
#pragma once

#include <numbers>

#include "base/macros.hpp"
#include "base/simd.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {

/// Wendland C4, kappa = 2: (1 - q/2)^6 (1 + 3 q + 35 q^2 / 12) in 2D and 3D,
/// (1 - q/2)^5 (1 + 5 q / 2 + 2 q^2) in 1D.
/// Source: Dehnen & Aly, MNRAS 425 (2012) 1068, table 1, scaled to support 2 h:
/// sigma_d = 3/(4 h), 9/(4 pi h^2), 495/(256 pi h^3).
template <int D>
struct WendlandC4 {
  static constexpr KernelName name = KernelName::wendland_c4;
  static constexpr double support = 2.0;
  static constexpr double sigma =
      D == 1 ? 3.0 / 4.0
             : (D == 2 ? 9.0 / (4.0 * std::numbers::pi) : 495.0 / (256.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    Real const t = maximum(number<Real>(1) - number<Real>(0.5) * q, number<Real>(0));
    Real const one = number<Real>(1);
    if constexpr (D == 1)
      return (t * t) * (t * t) * t * (one + q * (number<Real>(2.5) + number<Real>(2) * q));
    return (t * t) * (t * t) * (t * t) *
           (one + q * (number<Real>(3) + number<Real>(35.0 / 12.0) * q));
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const t = maximum(number<Real>(1) - number<Real>(0.5) * q, number<Real>(0));
    Real const one = number<Real>(1);
    if constexpr (D == 1)
      return number<Real>(-3.5) * (t * t) * (t * t) * (one + number<Real>(2) * q);
    return number<Real>(-14.0 / 3.0) * (t * t) * (t * t) * t * (one + number<Real>(2.5) * q);
  }
};

/// Wendland C6, kappa = 2: (1 - q/2)^8 (1 + 4 q + 25 q^2 / 4 + 4 q^3) in 2D and 3D,
/// (1 - q/2)^7 (1 + 7 q / 2 + 19 q^2 / 4 + 21 q^3 / 8) in 1D.
/// Source: Dehnen & Aly, MNRAS 425 (2012) 1068, table 1, scaled to support 2 h:
/// sigma_d = 55/(64 h), 39/(14 pi h^2), 1365/(512 pi h^3).
template <int D>
struct WendlandC6 {
  static constexpr KernelName name = KernelName::wendland_c6;
  static constexpr double support = 2.0;
  static constexpr double sigma =
      D == 1 ? 55.0 / 64.0
             : (D == 2 ? 39.0 / (14.0 * std::numbers::pi) : 1365.0 / (512.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    Real const t = maximum(number<Real>(1) - number<Real>(0.5) * q, number<Real>(0));
    Real const t4 = (t * t) * (t * t);
    Real const one = number<Real>(1);
    if constexpr (D == 1)
      return t4 * t * t * t *
             (one + q * (number<Real>(3.5) +
                         q * (number<Real>(19.0 / 4.0) + number<Real>(21.0 / 8.0) * q)));
    return t4 * t4 *
           (one + q * (number<Real>(4) + q * (number<Real>(25.0 / 4.0) + number<Real>(4) * q)));
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const t = maximum(number<Real>(1) - number<Real>(0.5) * q, number<Real>(0));
    Real const t4 = (t * t) * (t * t);
    Real const one = number<Real>(1);
    if constexpr (D == 1)
      return number<Real>(-4.5) * t4 * t * t *
             (one + q * (number<Real>(3) + number<Real>(35.0 / 12.0) * q));
    return number<Real>(-5.5) * t4 * t * t * t *
           (one + q * (number<Real>(3.5) + number<Real>(4) * q));
  }
};

}  // namespace moraine
