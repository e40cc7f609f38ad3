// Kernels with the Gaussian's bell, cut where it has become small.
#pragma once

#include <numbers>

#include "base/macros.hpp"
#include "base/simd.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {

/// e^(-x) for 0 <= x < 16, exact to rounding: whole and half powers of e by the binary digits of x,
/// the rest, less than 1/2, by the series around its middle. Beyond 16 it is that of 16 or less.
template <class Real>
MORAINE_FORMULA Real falling_exponential(Real x) {
  Real result = number<Real>(0.77880078307140487);  // e^(-1/4), the middle of the rest
  x = minimum(x, number<Real>(15.99));
  auto const take = [&](double part, double factor) __attribute__((always_inline)) {
    auto const below = x < number<Real>(part);
    result = select(below, result, result * number<Real>(factor));
    x = select(below, x, x - number<Real>(part));
  };
  take(8.0, 3.3546262790251185e-4);
  take(4.0, 1.8315638888734180e-2);
  take(2.0, 1.3533528323661270e-1);
  take(1.0, 3.6787944117144233e-1);
  take(0.5, 6.0653065971263342e-1);
  Real const y = x - number<Real>(0.25);
  // Nine terms of the series: the next one is below 0.25^10 / 10! = 3e-13.
  Real sum = number<Real>(1);
  for (int n = 9; n > 0; --n) sum = number<Real>(1) - y * sum * number<Real>(1.0 / n);
  return result * sum;
}

/// Gaussian e^(-q^2), cut at kappa = 3.
/// Source: Gingold & Monaghan, MNRAS 181 (1977) 375. sigma_d = 1/(sqrt(pi) h)^d divided by the part
/// of the integral that lies inside the cut, 0.999978, 0.999877, 0.999560 in 1, 2, 3 dimensions.
template <int D>
struct Gaussian {
  static constexpr KernelName name = KernelName::gaussian;
  static constexpr double support = 3.0;
  // 1D: erf(3); 2D: 1 - e^-9; 3D: erf(3) - 6 e^-9 / sqrt(pi)
  static constexpr double inside =
      D == 1 ? 0.9999779095030014 : (D == 2 ? 0.9998765901959134 : 0.9995601503471612);
  static constexpr double root = std::numbers::inv_sqrtpi;
  static constexpr double sigma =
      (D == 1 ? root : (D == 2 ? root * root : root * root * root)) / inside;

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    return select(q < number<Real>(3), falling_exponential(q * q), number<Real>(0));
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    return number<Real>(-2) * shape(q);
  }
};

/// Super-Gaussian (1 + d/2 - q^2) e^(-q^2), cut at kappa = 3: of fourth order, and for that
/// negative far outside. Source: Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543,
/// section 2.1; its 3/2 is 1 + d/2 of one dimension. sigma_d as that of the Gaussian; inside the
/// cut lie 1.000187, 1.000987, 1.003320 of the integral.
template <int D>
struct SuperGaussian {
  static constexpr KernelName name = KernelName::super_gaussian;
  static constexpr double support = 3.0;
  // That of the Gaussian and 3 e^-9 / sqrt(pi), 9 e^-9, 54 e^-9 / sqrt(pi).
  static constexpr double inside =
      D == 1 ? 1.0001867890809215 : (D == 2 ? 1.0009872784326934 : 1.0033199827497234);
  static constexpr double root = std::numbers::inv_sqrtpi;
  static constexpr double sigma =
      (D == 1 ? root : (D == 2 ? root * root : root * root * root)) / inside;

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    Real const bell = select(q < number<Real>(3), falling_exponential(q * q), number<Real>(0));
    return (number<Real>(1.0 + 0.5 * D) - q * q) * bell;
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const bell = select(q < number<Real>(3), falling_exponential(q * q), number<Real>(0));
    return number<Real>(-2) * (number<Real>(2.0 + 0.5 * D) - q * q) * bell;
  }
};

}  // namespace moraine
