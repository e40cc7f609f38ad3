// What every kernel must be: normalised, compact, positive, falling, with its own slope.
#include "smoothing/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace moraine {
namespace {

template <class Kernel, int D>
void check_kernel() {
  constexpr int pieces = 4000;  // of the support; midpoint rule, error below 1e-6
  double const step = kernel_support / pieces;
  double const shell = D == 1 ? 2.0 : (D == 2 ? 2.0 * std::numbers::pi : 4.0 * std::numbers::pi);
  double integral = 0.0;
  double last = Kernel::shape(0.0);
  for (int k = 0; k < pieces; ++k) {
    double const q = (k + 0.5) * step;
    double const w = Kernel::shape(q);
    EXPECT_GT(w, 0.0) << q;
    EXPECT_LT(w, last) << q;
    last = w;
    integral += Kernel::sigma * w * shell * std::pow(q, D - 1) * step;
    // Differences of fourth-order error 1e-5^2 times the third derivative, which is below 100.
    double const d = 1e-5;
    if (q > d && q + d < kernel_support) {
      EXPECT_NEAR(Kernel::slope_over_q(q) * q,
                  (Kernel::shape(q + d) - Kernel::shape(q - d)) / (2 * d), 1e-7);
    }
  }
  EXPECT_NEAR(integral, 1.0, 1e-6);
  for (double const q : {2.0, 2.5, 1e3, 1e12}) {
    EXPECT_EQ(Kernel::shape(q), 0.0);
    EXPECT_EQ(Kernel::slope_over_q(q), 0.0);
  }
  EXPECT_TRUE(std::isfinite(Kernel::slope_over_q(0.0)));
}

TEST(Kernels, CubicSpline) {
  check_kernel<CubicSpline<1>, 1>();
  check_kernel<CubicSpline<2>, 2>();
  check_kernel<CubicSpline<3>, 3>();
}

TEST(Kernels, WendlandC2) {
  check_kernel<WendlandC2<1>, 1>();
  check_kernel<WendlandC2<2>, 2>();
  check_kernel<WendlandC2<3>, 3>();
}

}  // namespace
}  // namespace moraine
