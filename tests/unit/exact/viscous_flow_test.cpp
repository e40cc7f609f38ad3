// Channel flows, Taylor-Green vortices and the standing wave.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "exact/channel_flow.hpp"
#include "exact/standing_wave.hpp"
#include "exact/taylor_green.hpp"

namespace moraine {
namespace {

// Long before the other plate is felt: Stokes' first problem, U erfc(distance / (2 sqrt(nu t))).
TEST(CouetteFlow, StartsAsStokesFirstProblem) {
  CouetteFlow const flow{1e-3, 1e-6, 2.0};
  for (double const t : {1e-8, 1e-5, 1e-3, 0.01})
    for (double const depth : {1e-6, 3e-5, 2e-4}) {
      double const expected = 2.0 * std::erfc(depth / (2.0 * std::sqrt(1e-6 * t)));
      EXPECT_NEAR(flow.velocity(1e-3 - depth, t), expected, 1e-11) << "t " << t << " d " << depth;
    }
}

// In the middle the first terms of both series decide: 2/pi and 4/pi^3.
TEST(ChannelFlow, BecomesSteady) {
  CouetteFlow const couette{1e-3, 1e-6, 1.0};
  PoiseuilleFlow const poiseuille{1e-3, 1e-6, 1.0};
  for (double const y : {0.0, 2e-4, 5e-4, 1e-3}) {
    EXPECT_NEAR(couette.velocity(y, 10.0), couette.steady_velocity(y), 1e-15);
    EXPECT_NEAR(poiseuille.velocity(y, 10.0), poiseuille.steady_velocity(y), 1e-15);
    EXPECT_NEAR(poiseuille.velocity(y, 0.0), 0.0, 0.0);
  }
  double const t = 1.0, decay = std::exp(-std::numbers::pi * std::numbers::pi);
  EXPECT_NEAR(0.5 - couette.velocity(5e-4, t), 2.0 / std::numbers::pi * decay, 1e-8);
  EXPECT_NEAR(0.125 - poiseuille.velocity(5e-4, t), 4.0 / std::pow(std::numbers::pi, 3) * decay,
              1e-8);
}

// Before the walls are felt all liquid falls freely, except for two layers.
TEST(PoiseuilleFlow, StartsInFreeFall) {
  PoiseuilleFlow const flow{1e-3, 1e-6, 3.0};
  for (double const t : {1e-6, 1e-4, 1e-3}) EXPECT_NEAR(flow.velocity(5e-4, t), 3.0 * t, 1e-14);
}

// du/dt = nu d2u/dy2 + f by central differences.
TEST(ChannelFlow, SolvesTheEquationOfMotion) {
  CouetteFlow const couette{1e-3, 1e-6, 1.0};
  PoiseuilleFlow const poiseuille{1e-3, 1e-6, 1.0};
  auto const residual = [](auto const& flow, double y, double t, double force) {
    double const dt = 1e-4, dy = 1e-6;
    double const rate = (flow.velocity(y, t + dt) - flow.velocity(y, t - dt)) / (2.0 * dt);
    double const bend =
        (flow.velocity(y + dy, t) - 2.0 * flow.velocity(y, t) + flow.velocity(y - dy, t)) /
        (dy * dy);
    return (rate - 1e-6 * bend - force) / (std::fabs(rate) + force);
  };
  for (double const t : {0.05, 0.2})
    for (double const y : {2e-4, 7e-4}) {
      EXPECT_NEAR(residual(couette, y, t, 0.0), 0.0, 1e-3);
      EXPECT_NEAR(residual(poiseuille, y, t, 1.0), 0.0, 1e-3);
    }
}

TEST(TaylorGreen, SolvesNavierStokes) {
  TaylorGreen const flow{2.0, 0.03, 1.5, 800.0};
  double const step = 1e-4;
  for (double const x : {0.1, 0.7, 1.3})
    for (double const y : {0.05, 0.9, 1.7}) {
      double const t = 0.4;
      auto const d = [&](auto const& f, double dx, double dy, double dt) {
        return (f(flow.sample(x + dx * step, y + dy * step, t + dt * step)) -
                f(flow.sample(x - dx * step, y - dy * step, t - dt * step))) /
               (2.0 * step);
      };
      auto const laplacian = [&](auto const& f) {
        return (f(flow.sample(x + step, y, t)) + f(flow.sample(x - step, y, t)) +
                f(flow.sample(x, y + step, t)) + f(flow.sample(x, y - step, t)) -
                4.0 * f(flow.sample(x, y, t))) /
               (step * step);
      };
      auto const u = [](TaylorGreen::Sample const& s) { return s.velocity_x; };
      auto const v = [](TaylorGreen::Sample const& s) { return s.velocity_y; };
      auto const p = [](TaylorGreen::Sample const& s) { return s.pressure; };
      auto const at = flow.sample(x, y, t);
      EXPECT_NEAR(d(u, 1, 0, 0) + d(v, 0, 1, 0), 0.0, 1e-6);
      auto const residual = [&](auto const& w, double px, double py) {
        return d(w, 0, 0, 1) + at.velocity_x * d(w, 1, 0, 0) + at.velocity_y * d(w, 0, 1, 0) +
               d(p, px, py, 0) / 800.0 - 0.03 * laplacian(w);
      };
      EXPECT_NEAR(residual(u, 1, 0), 0.0, 1e-5);
      EXPECT_NEAR(residual(v, 0, 1), 0.0, 1e-5);
    }
  EXPECT_NEAR(flow.mean_energy(1.0) / flow.mean_energy(0.0), std::exp(-2.0 * flow.decay_rate()),
              1e-14);
  EXPECT_NEAR(flow.mean_energy(0.0), 0.25 * 800.0 * 1.5 * 1.5, 1e-10);
}

TEST(StandingWave, FrequencyOfDeepAndShallowLiquid) {
  StandingWave deep;
  deep.wave_length = 1.0;
  deep.depth = 50.0;
  EXPECT_NEAR(deep.angular_frequency(), std::sqrt(9.81 * 2.0 * std::numbers::pi), 1e-12);
  StandingWave shallow;
  shallow.wave_length = 1000.0;
  shallow.depth = 0.1;
  EXPECT_NEAR(shallow.angular_frequency() / shallow.wave_number(), std::sqrt(0.981), 1e-6);
  // Tank of 2.2 m, 0.7 m of water: first mode 0.5198 Hz, from tables of linear theory.
  StandingWave tank;
  tank.wave_length = 4.4;
  tank.depth = 0.7;
  EXPECT_NEAR(1.0 / tank.period(), 0.5198, 1e-4);
}

// No flow through the bed; the surface moves with the liquid and has the pressure of the air, both
// to first order; irrotational and divergence-free inside.
TEST(StandingWave, SolvesTheLinearEquations) {
  StandingWave wave;
  wave.amplitude = 1e-3;
  double const step = 1e-5;
  for (double const x : {0.1, 0.35, 0.8})
    for (double const t : {0.1, 0.33, 0.9}) {
      EXPECT_NEAR(wave.sample(x, -wave.depth, t).velocity_z, 0.0, 1e-16);
      double const rate = (wave.elevation(x, t + step) - wave.elevation(x, t - step)) / (2 * step);
      EXPECT_NEAR(wave.sample(x, 0.0, t).velocity_z, rate, 1e-9);
      EXPECT_NEAR(wave.sample(x, 0.0, t).pressure, 9810.0 * wave.elevation(x, t), 1e-10);
      auto const d = [&](auto const& f, double dx, double dz, double dt) {
        return (f(wave.sample(x + dx * step, -0.3 + dz * step, t + dt * step)) -
                f(wave.sample(x - dx * step, -0.3 - dz * step, t - dt * step))) /
               (2.0 * step);
      };
      auto const u = [](StandingWave::Sample const& s) { return s.velocity_x; };
      auto const w = [](StandingWave::Sample const& s) { return s.velocity_z; };
      auto const p = [](StandingWave::Sample const& s) { return s.pressure; };
      EXPECT_NEAR(d(u, 1, 0, 0) + d(w, 0, 1, 0), 0.0, 1e-10);
      EXPECT_NEAR(d(u, 0, 1, 0) - d(w, 1, 0, 0), 0.0, 1e-10);
      EXPECT_NEAR(d(u, 0, 0, 1) + d(p, 1, 0, 0) / 1000.0, 0.0, 1e-8);
      EXPECT_NEAR(d(w, 0, 0, 1) + d(p, 0, 1, 0) / 1000.0 + 9.81, 0.0, 1e-8);
    }
}

TEST(StandingWave, DecaysAndKeepsItsDigitsOnDeepLiquid) {
  StandingWave wave;
  wave.kinematic_viscosity = 1e-3;
  EXPECT_NEAR(wave.decay_rate(), 2e-3 * std::numbers::pi * std::numbers::pi, 1e-15);
  double const period = wave.period();
  EXPECT_NEAR(wave.elevation(0.0, period) / wave.elevation(0.0, 0.0),
              std::exp(-wave.decay_rate() * period), 1e-12);
  wave.depth = 1e4;
  EXPECT_TRUE(std::isfinite(wave.sample(0.2, -5.0, 0.1).velocity_x));
  EXPECT_NEAR(wave.sample(0.2, -5.0, 0.1).velocity_x / wave.sample(0.2, 0.0, 0.1).velocity_x,
              std::exp(-5.0 * std::numbers::pi), 1e-12);
}

TEST(ViscousFlows, RefuseImpossibleValues) {
  EXPECT_THROW((CouetteFlow{0.0, 1.0, 1.0}.check()), std::invalid_argument);
  EXPECT_THROW((PoiseuilleFlow{1.0, 0.0, 1.0}.check()), std::invalid_argument);
  EXPECT_THROW((TaylorGreen{1.0, -1.0, 1.0, 1.0}.check()), std::invalid_argument);
  StandingWave wave;
  wave.depth = 0.0;
  EXPECT_THROW(wave.check(), std::invalid_argument);
}

}  // namespace
}  // namespace moraine
