// Kernels of one polynomial: of historical interest and for comparison.
#pragma once

#include <numbers>

#include "base/macros.hpp"
#include "base/simd.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {

/// Lucy's kernel, kappa = 1: (1 + 3 q) (1 - q)^3.
/// Source: Lucy, Astron. J. 82 (1977) 1013. sigma_d = 5/(4 h), 5/(pi h^2), 105/(16 pi h^3).
template <int D>
struct Lucy {
  static constexpr KernelName name = KernelName::lucy;
  static constexpr double support = 1.0;
  static constexpr double sigma =
      D == 1 ? 5.0 / 4.0 : (D == 2 ? 5.0 / std::numbers::pi : 105.0 / (16.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    Real const t = maximum(number<Real>(1) - q, number<Real>(0));
    return (number<Real>(1) + number<Real>(3) * q) * t * t * t;
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const t = maximum(number<Real>(1) - q, number<Real>(0));
    return number<Real>(-12) * t * t;
  }
};

/// Johnson's quadratic, kappa = 2: 3/16 q^2 - 3/4 q + 3/4 = 3/16 (2 - q)^2. Its slope is steepest
/// at q = 0, so that particles do not clump.
/// Source: Johnson, Stryk & Beissel, Comput. Methods Appl. Mech. Eng. 139 (1996) 347.
/// sigma_d = 1/h, 2/(pi h^2), 5/(4 pi h^3).
/// Range: slope_over_q grows as 1/q towards q = 0 and stays what it is at q = 1e-6 below that.
template <int D>
struct JohnsonQuadratic {
  static constexpr KernelName name = KernelName::johnson_quadratic;
  static constexpr double support = 2.0;
  static constexpr double sigma =
      D == 1 ? 1.0 : (D == 2 ? 2.0 / std::numbers::pi : 5.0 / (4.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    Real const t = maximum(number<Real>(2) - q, number<Real>(0));
    return number<Real>(3.0 / 16.0) * t * t;
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const t = maximum(number<Real>(2) - q, number<Real>(0));
    return number<Real>(-3.0 / 8.0) * t / maximum(q, number<Real>(1e-6));
  }
};

/// Dome, kappa = 1: 1 - q^2. Its slope ends with a jump.
/// Source: Hicks & Liebrock, Appl. Math. Comput. 93 (1998) 213 (quadratic kernel).
/// sigma_d = 3/(4 h), 2/(pi h^2), 15/(8 pi h^3).
template <int D>
struct Dome {
  static constexpr KernelName name = KernelName::dome;
  static constexpr double support = 1.0;
  static constexpr double sigma =
      D == 1 ? 3.0 / 4.0 : (D == 2 ? 2.0 / std::numbers::pi : 15.0 / (8.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    return maximum(number<Real>(1) - q * q, number<Real>(0));
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    return select(q < number<Real>(1), number<Real>(-2), number<Real>(0));
  }
};

/// Liu's quartic, kappa = 2: 2/3 - 9/8 q^2 + 19/24 q^3 - 5/32 q^4. Beyond q = 1.696 it is slightly
/// negative, at most by 0.0024 of its peak, and beyond 1.8 it rises to zero.
/// Source: Liu, Liu & Lam, J. Comput. Appl. Math. 155 (2003) 263; Liu & Liu, Smoothed Particle
/// Hydrodynamics (2003), eq. 3.14. sigma_d = 1/h, 15/(7 pi h^2), 315/(208 pi h^3).
template <int D>
struct LiuQuartic {
  static constexpr KernelName name = KernelName::liu_quartic;
  static constexpr double support = 2.0;
  static constexpr double sigma =
      D == 1 ? 1.0
             : (D == 2 ? 15.0 / (7.0 * std::numbers::pi) : 315.0 / (208.0 * std::numbers::pi));

  template <class Real>
  MORAINE_FORMULA static Real shape(Real const& q) {
    // With the double root at q = 2 taken out.
    Real const t = maximum(number<Real>(2) - q, number<Real>(0));
    Real const sixth = number<Real>(1.0 / 6.0);
    return t * t * (sixth + q * (sixth - number<Real>(5.0 / 32.0) * q));
  }

  template <class Real>
  MORAINE_FORMULA static Real slope_over_q(Real const& q) {
    Real const t = maximum(number<Real>(2) - q, number<Real>(0));
    return number<Real>(-0.125) * t * (number<Real>(9) - number<Real>(5) * q);
  }
};

}  // namespace moraine
