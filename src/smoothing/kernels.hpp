// Smoothing kernels W(r, h) = sigma_d / h^d * shape(q), q = r / h, zero from q = kappa on.
//
// Each family gives, for a generic number type:
//   shape(q)         the kernel without its normalisation
//   slope_over_q(q)  (d shape / dq) / q, so that grad W = sigma_d / h^(d+2) slope_over_q(q) x_ij
//   sigma            normalisation sigma_d in d dimensions
//   support          kappa
// Both functions are exactly zero from q = kappa on: the pair loops need no mask.
//
// The two families of this file have kappa = 2 and instantiations of the pair loops of their own.
// For all others, see any_kernel.hpp.
#pragma once

#include <numbers>

#include "base/macros.hpp"
#include "base/simd.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {

/// Cubic B-spline (M4): 2/3 - q^2 + q^3/2 for q < 1, (2 - q)^3 / 6 for 1 <= q < 2.
/// Source: Monaghan & Lattanzio, Astron. Astrophys. 149 (1985) 135, eq. 21; sigma_d = 1/h,
/// 15/(7 pi h^2), 3/(2 pi h^3) for this scaling of the shape.
template <int D>
struct CubicSpline {
  static constexpr KernelName name = KernelName::cubic_spline;
  static constexpr double support = 2.0;
  static constexpr double sigma =
      D == 1 ? 1.0 : (D == 2 ? 15.0 / (7.0 * std::numbers::pi) : 3.0 / (2.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    Real const inner = number<Real>(2.0 / 3.0) - q * q * (number<Real>(1) - number<Real>(0.5) * q);
    Real const t = maximum(number<Real>(2) - q, number<Real>(0));
    return select(q < number<Real>(1), inner, number<Real>(1.0 / 6.0) * t * t * t);
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const inner = number<Real>(1.5) * q - number<Real>(2);
    Real const t = maximum(number<Real>(2) - q, number<Real>(0));
    return select(q < number<Real>(1), inner,
                  number<Real>(-0.5) * t * t / maximum(q, number<Real>(1)));
  }
};

/// Wendland C2: (1 - q/2)^4 (1 + 2 q) in 2D and 3D, (1 - q/2)^3 (1 + 3 q / 2) in 1D.
/// Source: Wendland, Adv. Comput. Math. 4 (1995) 389; scaled as in Dehnen & Aly, MNRAS 425 (2012)
/// 1068, table 1, to support 2 h: sigma_d = 5/(8 h), 7/(4 pi h^2), 21/(16 pi h^3).
template <int D>
struct WendlandC2 {
  static constexpr KernelName name = KernelName::wendland_c2;
  static constexpr double support = 2.0;
  static constexpr double sigma =
      D == 1 ? 5.0 / 8.0
             : (D == 2 ? 7.0 / (4.0 * std::numbers::pi) : 21.0 / (16.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    Real const t = maximum(number<Real>(1) - number<Real>(0.5) * q, number<Real>(0));
    if constexpr (D == 1) return t * t * t * (number<Real>(1) + number<Real>(1.5) * q);
    return (t * t) * (t * t) * (number<Real>(1) + number<Real>(2) * q);
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const t = maximum(number<Real>(1) - number<Real>(0.5) * q, number<Real>(0));
    if constexpr (D == 1) return number<Real>(-3) * t * t;
    return number<Real>(-5) * t * t * t;
  }
};

}  // namespace moraine
