// B-splines of higher order: smoother than the cubic one, and wider in their own h.
#pragma once

#include <numbers>

#include "base/macros.hpp"
#include "base/simd.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {

/// Quartic spline (M5), kappa = 2.5: with (x)_+ = max(x, 0),
///
///   (5/2 - q)_+^4 - 5 (3/2 - q)_+^4 + 10 (1/2 - q)_+^4
///
/// Source: Morris, Analysis of Smoothed Particle Hydrodynamics with Applications, PhD thesis,
/// Monash University (1996); Liu & Liu, Smoothed Particle Hydrodynamics (2003), eq. 3.8.
/// sigma_d = 1/(24 h), 96/(1199 pi h^2), 1/(20 pi h^3).
template <int D>
struct QuarticSpline {
  static constexpr KernelName name = KernelName::quartic_spline;
  static constexpr double support = 2.5;
  static constexpr double sigma =
      D == 1 ? 1.0 / 24.0
             : (D == 2 ? 96.0 / (1199.0 * std::numbers::pi) : 1.0 / (20.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    Real const a = beyond(q, 2.5);
    Real const b = beyond(q, 1.5);
    Real const c = beyond(q, 0.5);
    return (a * a) * (a * a) - number<Real>(5) * (b * b) * (b * b) +
           number<Real>(10) * (c * c) * (c * c);
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const half = number<Real>(0.5);
    Real const a = beyond(q, 2.5);
    Real const b = beyond(q, 1.5);
    Real const outer =
        number<Real>(-4) * (a * a * a - number<Real>(5) * b * b * b) / maximum(q, half);
    return select(q < half, number<Real>(24) * q * q - number<Real>(30), outer);
  }

 private:
  template <class Real>
  MORAINE_FORMULA static Real beyond(Real const& q, double knot) {
    return maximum(number<Real>(knot) - q, number<Real>(0));
  }
};

/// Quintic spline (M6), kappa = 3: (3 - q)_+^5 - 6 (2 - q)_+^5 + 15 (1 - q)_+^5.
/// Source: Morris, Fox & Zhu, J. Comput. Phys. 136 (1997) 214, eq. 16.
/// sigma_d = 1/(120 h), 7/(478 pi h^2), 1/(120 pi h^3); the last is often misprinted 3/(359 pi
/// h^3).
template <int D>
struct QuinticSpline {
  static constexpr KernelName name = KernelName::quintic_spline;
  static constexpr double support = 3.0;
  static constexpr double sigma =
      D == 1 ? 1.0 / 120.0
             : (D == 2 ? 7.0 / (478.0 * std::numbers::pi) : 1.0 / (120.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    return power5(q, 3) - number<Real>(6) * power5(q, 2) + number<Real>(15) * power5(q, 1);
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const one = number<Real>(1);
    Real const a = maximum(number<Real>(3) - q, number<Real>(0));
    Real const b = maximum(number<Real>(2) - q, number<Real>(0));
    Real const outer = number<Real>(-5) *
                       ((a * a) * (a * a) - number<Real>(6) * (b * b) * (b * b)) / maximum(q, one);
    Real const inner = number<Real>(-120) + q * q * (number<Real>(120) - number<Real>(50) * q);
    return select(q < one, inner, outer);
  }

 private:
  template <class Real>
  MORAINE_FORMULA static Real power5(Real const& q, double knot) {
    Real const t = maximum(number<Real>(knot) - q, number<Real>(0));
    return (t * t) * (t * t) * t;
  }
};

}  // namespace moraine
