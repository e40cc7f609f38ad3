#include "records/oscillator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

// Ground that starts to accelerate evenly: u = -(A/w^2) (1 - e^(-z w t) (cos w_d t + z w/w_d sin
// w_d t)), for steps that are short and long against the period, on both sides of the power series.
TEST(Oscillator, StepOfTheGroundInClosedForm) {
  for (double const zeta : {0.0, 0.005, 0.05, 0.6})
    for (double const dt : {0.001, 0.0795, 0.0797, 0.5, 3.0}) {
      double const w = 2.0 * std::numbers::pi, a = 1.7;
      double const w_d = w * std::sqrt(1.0 - zeta * zeta);
      Oscillator const oscillator(w, zeta, dt);
      OscillatorState state;
      for (int n = 1; n <= 40; ++n) {
        state = oscillator.advance(state, a, a);
        double const t = n * dt;
        double const wave = std::cos(w_d * t) + zeta * w / w_d * std::sin(w_d * t);
        double const exact = -a / (w * w) * (1.0 - std::exp(-zeta * w * t) * wave);
        EXPECT_NEAR(state.displacement, exact, 1e-13) << zeta << ' ' << dt << ' ' << n;
      }
    }
}

// Ground whose acceleration grows evenly, without damping: u = -(B/w^2) (t - sin(w t)/w).
TEST(Oscillator, RampOfTheGroundInClosedForm) {
  double const w = 3.0, slope = 0.8;
  for (double const dt : {0.01, 0.16, 0.17, 1.0}) {
    Oscillator const oscillator(w, 0.0, dt);
    OscillatorState state;
    for (int n = 1; n <= 30; ++n) {
      state = oscillator.advance(state, slope * (n - 1) * dt, slope * n * dt);
      double const t = n * dt;
      EXPECT_NEAR(state.displacement, -slope / (w * w) * (t - std::sin(w * t) / w), 1e-12);
      EXPECT_NEAR(state.velocity, -slope / (w * w) * (1.0 - std::cos(w * t)), 1e-12);
    }
  }
}

// A harmonic ground is not straight between its values: the error falls with the square of the
// step.
TEST(Oscillator, HarmonicGroundConvergesWithTheSquareOfTheStep) {
  double const w = 5.0, w_g = 3.0;
  double before = 0.0;
  for (int steps = 40; steps <= 640; steps *= 2) {
    double const dt = 4.0 / steps;
    Oscillator const oscillator(w, 0.0, dt);
    OscillatorState state;
    for (int n = 1; n <= steps; ++n)
      state = oscillator.advance(state, std::sin(w_g * (n - 1) * dt), std::sin(w_g * n * dt));
    // u = (w_g/w sin(w t) - sin(w_g t)) / (w^2 - w_g^2)
    double const exact = (w_g / w * std::sin(w * 4.0) - std::sin(w_g * 4.0)) / (w * w - w_g * w_g);
    double const error = std::fabs(state.displacement - exact);
    if (before > 0.0) {
      EXPECT_NEAR(before / error, 4.0, 0.2) << steps;
    }
    before = error;
  }
}

TEST(Oscillator, AccelerationsBelongToTheEquationOfMotion) {
  Oscillator const oscillator(4.0, 0.1, 0.01);
  OscillatorState const state{0.3, -0.2};
  EXPECT_DOUBLE_EQ(oscillator.absolute_acceleration(state), -0.8 * -0.2 - 16.0 * 0.3);
  EXPECT_DOUBLE_EQ(oscillator.relative_acceleration(state, 1.5), -1.5 - 0.8 * -0.2 - 16.0 * 0.3);
}

TEST(Oscillator, RefusesWhatDoesNotOscillate) {
  auto const refusal = [](double w, double zeta, double dt) {
    return message_of<std::invalid_argument>([&] { Oscillator(w, zeta, dt); });
  };
  EXPECT_EQ(refusal(0.0, 0.1, 0.1), "oscillator: frequency and time step must be positive");
  EXPECT_EQ(refusal(1.0, 0.1, -0.1), "oscillator: frequency and time step must be positive");
  EXPECT_EQ(refusal(1.0, 1.0, 0.1), "oscillator: the damping ratio must be at least 0 and below 1");
  EXPECT_EQ(refusal(1.0, -0.1, 0.1),
            "oscillator: the damping ratio must be at least 0 and below 1");
}

}  // namespace
}  // namespace moraine
