// What every kernel must be: normalised, compact, positive and falling where it claims to be, with
// its own slope.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "smoothing/viscous_stiffness.hpp"

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

// Without the softening by phi = 0.1 h the stiffness is 7/6, 1 and 10/7 for these; it takes a few
// percent.
TEST(Kernels, ViscousStiffnessIsThatOfTheFormula) {
  auto const expect = [](double stiffness, double sharp) {
    EXPECT_LT(stiffness, sharp);
    EXPECT_GT(stiffness, 0.94 * sharp);
  };
  expect(viscous_stiffness(AnyKernel<3>(KernelName::wendland_c2)), 7.0 / 6.0);
  expect(viscous_stiffness(AnyKernel<3>(KernelName::cubic_spline)), 1.0);
  expect(viscous_stiffness(AnyKernel<2>(KernelName::cubic_spline)), 10.0 / 7.0);
  EXPECT_EQ(viscous_signal(AnyKernel<2>(KernelName::wendland_c2)), 0.6);
  EXPECT_EQ(viscous_signal(AnyKernel<3>(KernelName::cubic_spline)), 0.6);
  EXPECT_GT(viscous_signal(AnyKernel<1>(KernelName::super_gaussian)), 1.7);
}

TEST(Kernels, AreInTheOrderOfTheirNames) {
  for (std::size_t k = 0; k < kernel_table.size(); ++k)
    EXPECT_EQ(static_cast<std::size_t>(kernel_table[k].kernel), k);
}

}  // namespace
}  // namespace moraine
