// What a kernel asks of the time step where artificial viscosity acts.
#pragma once

#include <numbers>

#include "smoothing/any_kernel.hpp"

namespace moraine {

/// How fast artificial viscosity wears down the velocity of one particle against its neighbours, in
/// units of (alpha c + beta |mu|) / h: with mu and phi = 0.1 h of Monaghan's viscosity,
///
///   K = 1/d integral of |W'(q)| / q q^2 / (q^2 + 0.01) dV,   h = 1
///
/// The quadratic part answers to a change of velocity twice as strongly, so an explicit step must
/// be shorter than about h / (K beta |mu|). K is 0.4 to 2.3 for most kernels; for narrow ones in 1D
/// up to 3.6, for the super-Gaussian up to 6.7.
template <int D>
double viscous_stiffness(AnyKernel<D> const& kernel) {
  constexpr int pieces = 400;  // midpoint rule, error below 1e-3
  constexpr double step = kernel_support / pieces;
  double sum = 0.0;
  for (int k = 0; k < pieces; ++k) {
    double const q = (k + 0.5) * step;
    double const shell =
        D == 1 ? 2.0 : (D == 2 ? 2.0 * std::numbers::pi * q : 4.0 * std::numbers::pi * q * q);
    double const slope = kernel.sigma * kernel.slope_over_q(q);
    sum += (slope < 0.0 ? -slope : slope) * shell * q * q / (q * q + 0.01) * step;
  }
  return sum / D;
}

inline double viscous_stiffness(KernelName kernel, int dimension) {
  if (dimension == 1) return viscous_stiffness(AnyKernel<1>(kernel));
  if (dimension == 2) return viscous_stiffness(AnyKernel<2>(kernel));
  return viscous_stiffness(AnyKernel<3>(kernel));
}

/// The factor of alpha c + beta |mu| in the signal speed: the usual 0.6 of Monaghan, Annu. Rev.
/// Astron. Astrophys. 30 (1992) 543, section 4, where K is up to 2.3, about that of the cubic
/// spline in 1D; the rise with the square of K beyond is our own choice. A charge in water in 1D
/// (`moraine verify tnt-kernels`, alpha = 1, beta = 10, 60 us) was stable up to Courant numbers of
/// 0.4 with Wendland C2 and the cubic spline, 0.35 with the quintic spline, the Gaussian and
/// Wendland C6, 0.5 with the super-Gaussian; with 0.6 throughout, those with K of 3.3 and
/// more gained energy at 0.3.
template <int D>
double viscous_signal(AnyKernel<D> const& kernel) {
  double const stiffness = viscous_stiffness(kernel);
  return stiffness > 2.3 ? 0.6 * (stiffness / 2.3) * (stiffness / 2.3) : 0.6;
}

inline double viscous_signal(KernelName kernel, int dimension) {
  if (dimension == 1) return viscous_signal(AnyKernel<1>(kernel));
  if (dimension == 2) return viscous_signal(AnyKernel<2>(kernel));
  return viscous_signal(AnyKernel<3>(kernel));
}

}  // namespace moraine
