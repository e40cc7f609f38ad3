#include "blast/pulse.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moraine::blast {
namespace {

/// Integral by Simpson's rule.
template <class F>
double integral(F const& f, double a, double b, int steps = 2000) {
  double const h = (b - a) / steps;
  double sum = f(a) + f(b);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(a + i * h);
  return sum * h / 3.0;
}

TEST(Pulse, ImpulsesAreIntegrals) {
  double const p = 1.7e5, t = 4e-3;
  EXPECT_NEAR(integral([&](double x) { return triangle_pulse(p, t, x); }, 0.0, t),
              triangle_impulse(p, t), 1e-10 * p * t);
  for (double const k : {0.0, 1e-4, 0.999e-3, 1.001e-3, 0.1, 1.0, 4.0, 20.0})
    EXPECT_NEAR(integral([&](double x) { return friedlander_pulse(p, t, k, x); }, 0.0, t),
                friedlander_impulse(p, t, k), 1e-9 * p * t)
        << k;
}

TEST(Pulse, EndsAndSuction) {
  EXPECT_EQ(triangle_pulse(5.0, 2.0, 0.0), 5.0);
  EXPECT_EQ(triangle_pulse(5.0, 2.0, 2.0), 0.0);
  EXPECT_EQ(triangle_pulse(5.0, 2.0, 3.0), 0.0);
  EXPECT_EQ(triangle_pulse(5.0, 2.0, -1e-9), 0.0);
  EXPECT_EQ(friedlander_pulse(5.0, 2.0, 1.5, 0.0), 5.0);
  EXPECT_EQ(friedlander_pulse(5.0, 2.0, 1.5, 2.0), 0.0);
  EXPECT_EQ(friedlander_pulse(5.0, 2.0, 1.5, -1.0), 0.0);
  double lowest = 0.0;
  for (double t = 2.0; t < 20.0; t += 1e-3)
    lowest = std::min(lowest, friedlander_pulse(5.0, 2.0, 1.5, t));
  EXPECT_NEAR(friedlander_suction(5.0, 2.0, 1.5), lowest, 1e-6);
  EXPECT_NEAR(friedlander_suction(5.0, 2.0, 1.5), -5.0 * std::exp(-2.5) / 1.5, 1e-14);
}

// With k = 1 the suction carries away the whole impulse of the positive phase.
TEST(Pulse, FriedlanderWithDecayOneHasNoImpulseInAll) {
  double const all =
      integral([](double t) { return friedlander_pulse(1.0, 1.0, 1.0, t); }, 0.0, 60.0, 60000);
  EXPECT_NEAR(all, 0.0, 1e-10);
}

TEST(Pulse, DecayFromImpulseAndBack) {
  for (double const k : {1e-3, 0.5, 1.0, 3.0, 30.0}) {
    auto const found = friedlander_decay(2e5, 3e-3, friedlander_impulse(2e5, 3e-3, k));
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, k, 1e-8 * (1.0 + k));
  }
  EXPECT_FALSE(friedlander_decay(1.0, 1.0, 0.51));
  EXPECT_FALSE(friedlander_decay(1.0, 1.0, 0.0));
  EXPECT_NEAR(friedlander_decay(1.0, 1.0, 0.5).value_or(-1.0), 0.0, 1e-6);
}

TEST(Pulse, ExponentialFallsByEInItsTime) {
  EXPECT_NEAR(exponential_pulse(3.0, 2.0, 2.0), 3.0 / std::exp(1.0), 1e-15);
  EXPECT_EQ(exponential_pulse(3.0, 2.0, -1.0), 0.0);
}

}  // namespace
}  // namespace moraine::blast
