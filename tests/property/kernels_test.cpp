// What every kernel must be: normalised, compact, positive and falling where it claims to be, with
// its own slope.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "smoothing/any_kernel.hpp"

namespace moraine {
namespace {

/// What is true of a kernel beside its integral.
struct Character {
  double positive_to = 1.0;  // part of the support up to which it is positive and falls
  double smallest = 0.0;     // share of its peak, beyond
  double jump = 0.0;         // share of its peak, at the end of the support
  bool bends = true;         // its slope vanishes at q = 0
};

Character character_of(KernelName name) {
  switch (name) {
    case KernelName::gaussian:
      return {1.0, 0.0, std::exp(-9.0), true};
    case KernelName::super_gaussian:  // falls to q^2 = 2 + d/2, positive to 1 + d/2
      return {std::sqrt(1.5) / 3.0, -0.2, 8.0 * std::exp(-9.0), true};
    case KernelName::liu_quartic:
      return {1.69 / 2.0, -0.0023751, 0.0, true};  // least at q = 1.8
    case KernelName::johnson_quadratic:
      return {1.0, 0.0, 0.0, false};
    default:
      return {};
  }
}

template <int D, class Kernel>
void check(Kernel const& kernel, double support, Character const& character) {
  constexpr int pieces = 4000;  // of the support; midpoint rule, error below 1e-6
  double const step = support / pieces;
  double const shell = D == 1 ? 2.0 : (D == 2 ? 2.0 * std::numbers::pi : 4.0 * std::numbers::pi);
  double const peak = kernel.shape(0.0);
  double integral = 0.0;
  double last = peak;
  for (int k = 0; k < pieces; ++k) {
    double const q = (k + 0.5) * step;
    double const w = kernel.shape(q);
    if (q < character.positive_to * support) {
      EXPECT_GT(w, 0.0) << q;
      EXPECT_LT(w, last) << q;
    }
    EXPECT_GE(w, character.smallest * peak) << q;
    last = w;
    integral += kernel.sigma * w * shell * std::pow(q, D - 1) * step;
    // Differences of fourth-order error 1e-5^2 times the third derivative.
    double const d = 1e-5;
    if (q > d && q + d < support) {
      EXPECT_NEAR(kernel.slope_over_q(q) * q, (kernel.shape(q + d) - kernel.shape(q - d)) / (2 * d),
                  1e-7 * std::max(1.0, peak))
          << q;
    }
  }
  EXPECT_NEAR(integral, 1.0, 1e-6);
  EXPECT_LE(std::fabs(kernel.shape(support * (1.0 - 1e-9))), (character.jump + 1e-8) * peak);
  for (double const q : {1.0, 1.25, 500.0, 1e12}) {
    EXPECT_EQ(kernel.shape(q * support), 0.0);
    EXPECT_EQ(kernel.slope_over_q(q * support), 0.0);
  }
  EXPECT_TRUE(std::isfinite(kernel.slope_over_q(0.0)));
  if (character.bends) {
    EXPECT_NEAR(kernel.slope_over_q(1e-9) * 1e-9, 0.0, 1e-6 * peak);
  }
}

template <template <int> class Family>
void check_family() {
  auto const in = [&]<int D>(std::integral_constant<int, D>) {
    SCOPED_TRACE(D);
    Character const character = character_of(Family<D>::name);
    check<D>(Family<D>{}, Family<D>::support, character);
    check<D>(AnyKernel<D>(Family<D>::name), kernel_support, character);
  };
  in(std::integral_constant<int, 1>{});
  in(std::integral_constant<int, 2>{});
  in(std::integral_constant<int, 3>{});
}

TEST(Kernels, CubicSpline) { check_family<CubicSpline>(); }
TEST(Kernels, WendlandC2) { check_family<WendlandC2>(); }
TEST(Kernels, WendlandC4) { check_family<WendlandC4>(); }
TEST(Kernels, WendlandC6) { check_family<WendlandC6>(); }
TEST(Kernels, QuarticSpline) { check_family<QuarticSpline>(); }
TEST(Kernels, QuinticSpline) { check_family<QuinticSpline>(); }
TEST(Kernels, Gaussian) { check_family<Gaussian>(); }
TEST(Kernels, SuperGaussian) { check_family<SuperGaussian>(); }
TEST(Kernels, Lucy) { check_family<Lucy>(); }
TEST(Kernels, JohnsonQuadratic) { check_family<JohnsonQuadratic>(); }
TEST(Kernels, Dome) { check_family<Dome>(); }
TEST(Kernels, LiuQuartic) { check_family<LiuQuartic>(); }

TEST(Kernels, FallingExponentialIsExactToRounding) {
  for (double x = 0.0; x < 15.9; x += 0.0037) {
    EXPECT_NEAR(falling_exponential(x), std::exp(-x), 2e-12 * std::exp(-x)) << x;
    EXPECT_NEAR(falling_exponential(static_cast<float>(x)), std::exp(-x), 1e-6 * std::exp(-x));
  }
  EXPECT_LE(falling_exponential(1e30), std::exp(-15.9));
}

/// max k |W(k)| over wave numbers, W(k) the Fourier transform of a kernel with h = 1.
template <int D>
double stiffness(AnyKernel<D> const& kernel) {
  constexpr int pieces = 1000;
  double most = 0.0;
  for (double k = 0.05; k < 8.0; k += 0.05) {
    double transform = 0.0;
    for (int i = 0; i < pieces; ++i) {
      double const r = (i + 0.5) * kernel_support / pieces;
      double const wave = D == 1
                              ? 2.0 * std::cos(k * r)
                              : (D == 2 ? 2.0 * std::numbers::pi * r * std::cyl_bessel_j(0.0, k * r)
                                        : 4.0 * std::numbers::pi * r * std::sin(k * r) / k);
      transform += kernel.sigma * kernel.shape(r) * wave * kernel_support / pieces;
    }
    most = std::max(most, k * std::fabs(transform));
  }
  return most;
}

TEST(Kernels, TimeStepsFollowTheFastestWaves) {
  for (KernelInfo const& kernel : kernel_table) {
    double const most =
        std::max({stiffness(AnyKernel<1>(kernel.kernel)), stiffness(AnyKernel<2>(kernel.kernel)),
                  stiffness(AnyKernel<3>(kernel.kernel))});
    EXPECT_LT(kernel.time_step * most, 1.5) << kernel.name;
    EXPECT_GT(most, 0.65) << kernel.name;
  }
  EXPECT_NEAR(stiffness(AnyKernel<1>(KernelName::cubic_spline)), 1.0375, 0.002);
}

TEST(Kernels, AreInTheOrderOfTheirNames) {
  for (std::size_t k = 0; k < kernel_table.size(); ++k)
    EXPECT_EQ(static_cast<std::size_t>(kernel_table[k].kernel), k);
}

}  // namespace
}  // namespace moraine
