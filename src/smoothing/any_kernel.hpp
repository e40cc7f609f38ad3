// A kernel that is chosen at run time.
#pragma once

#include <type_traits>

#include "smoothing/gaussian_kernels.hpp"
#include "smoothing/kernels.hpp"
#include "smoothing/polynomial_kernels.hpp"
#include "smoothing/spline_kernels.hpp"
#include "smoothing/wendland_kernels.hpp"

namespace moraine {

/// One of all kernels, written in q = r / h where its support ends at kernel_support.
///
/// In the pair loops the choice is one jump for all lanes, the same each time: it costs little
/// beside the formula (docs/decisions/0016-kernels-by-a-switch.md), and saves instantiations.
template <int D>
class AnyKernel {
 public:
  explicit AnyKernel(KernelName name) : name_(name) {
    visit([this](auto family) {
      using Family = decltype(family);
      double const stretch = Family::support / kernel_support;
      sigma = Family::sigma *
              (D == 1 ? stretch : (D == 2 ? stretch * stretch : stretch * stretch * stretch));
      return 0;
    });
  }

  template <class Real>
  MORAINE_FORMULA Real shape(Real const& q) const {
    return visit([&](auto family) __attribute__((always_inline)) {
      using Family = decltype(family);
      return Family::shape(number<Real>(Family::support / kernel_support) * q);
    });
  }

  template <class Real>
  MORAINE_FORMULA Real slope_over_q(Real const& q) const {
    return visit([&](auto family) __attribute__((always_inline)) {
      using Family = decltype(family);
      constexpr double stretch = Family::support / kernel_support;
      return number<Real>(stretch * stretch) * Family::slope_over_q(number<Real>(stretch) * q);
    });
  }

  double sigma = 0.0;  // of the kernel in this q

 private:
  template <class Use>
  MORAINE_FORMULA auto visit(Use&& use) const {
    switch (name_) {
      case KernelName::cubic_spline:
        return use(CubicSpline<D>{});
      case KernelName::wendland_c2:
        return use(WendlandC2<D>{});
      case KernelName::wendland_c4:
        return use(WendlandC4<D>{});
      case KernelName::wendland_c6:
        return use(WendlandC6<D>{});
      case KernelName::quartic_spline:
        return use(QuarticSpline<D>{});
      case KernelName::quintic_spline:
        return use(QuinticSpline<D>{});
      case KernelName::gaussian:
        return use(Gaussian<D>{});
      case KernelName::super_gaussian:
        return use(SuperGaussian<D>{});
      case KernelName::lucy:
        return use(Lucy<D>{});
      case KernelName::johnson_quadratic:
        return use(JohnsonQuadratic<D>{});
      case KernelName::dome:
        return use(Dome<D>{});
      case KernelName::liu_quartic:
        break;
    }
    return use(LiuQuartic<D>{});
  }

  KernelName name_;
};

/// The kernel of a family; what is chosen at run time is told its name.
template <class Kernel>
Kernel make_kernel([[maybe_unused]] KernelName name) {
  if constexpr (std::is_constructible_v<Kernel, KernelName>)
    return Kernel(name);
  else
    return Kernel{};
}

}  // namespace moraine
