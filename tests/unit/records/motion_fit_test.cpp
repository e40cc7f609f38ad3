#include "records/motion_fit.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/gravity.hpp"
#include "records/measures.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

MotionTarget target_of(double ratio, double period, double duration) {
  MotionTarget target;
  target.peak_acceleration = 0.35 * standard_gravity;
  target.velocity_ratio = ratio;
  target.predominant_period = period;
  target.duration = duration;
  return target;
}

// Motions like three records of high, middle and low frequency (a 2018 paper on rectangular
// concrete tanks: Coalinga, Northridge, Loma Prieta), for several seeds, measured anew.
TEST(MotionFit, MeetsTheMeasuresOfThreeRecords) {
  for (auto const& target :
       {target_of(0.028, 0.14, 20.0), target_of(0.096, 0.28, 25.0), target_of(0.174, 0.54, 30.0)})
    for (std::uint64_t const seed : {1U, 2U, 77U}) {
      FittedMotion const fit = fit_motion(target, seed);
      MotionMeasures const m = measure(fit.record);
      EXPECT_EQ(m.acceleration.value, target.peak_acceleration);
      double const ratio = m.velocity.value / m.acceleration.value;
      EXPECT_NEAR(ratio, target.velocity_ratio, close_enough * target.velocity_ratio) << seed;
      EXPECT_NEAR(m.predominant_period, target.predominant_period,
                  close_enough * target.predominant_period)
          << seed;
      EXPECT_DOUBLE_EQ(fit.velocity_ratio, ratio);
      EXPECT_DOUBLE_EQ(fit.predominant_period, m.predominant_period);
      EXPECT_LE(fit.error(target), close_enough);
      GroundPath const path = integrate(fit.record);
      EXPECT_NEAR(path.displacement.back(), 0.0, 1e-10);
      EXPECT_DOUBLE_EQ(fit.record.duration(), target.duration);
    }
}

TEST(MotionFit, SameSeedSameBits) {
  MotionTarget const target = target_of(0.096, 0.28, 20.0);
  EXPECT_EQ(fit_motion(target, 5).record.acceleration, fit_motion(target, 5).record.acceleration);
  EXPECT_NE(fit_motion(target, 5).record.acceleration, fit_motion(target, 6).record.acceleration);
}

// Less velocity than a harmonic motion of that period has: the nearest comes back with its error.
TEST(MotionFit, TellsWhenTheTargetIsOutOfReach) {
  MotionTarget target = target_of(0.010, 0.5, 6.0);
  target.time_step = 0.02;
  FittedMotion const fit = fit_motion(target, 1);
  EXPECT_GT(fit.error(target), 0.2);
  EXPECT_EQ(fit.peak_acceleration, target.peak_acceleration);
}

TEST(MotionFit, RefusesTargetsThatMakeNoSense) {
  auto const refusal = [](MotionTarget const& target) {
    return message_of<std::invalid_argument>([&] { fit_motion(target, 1); });
  };
  EXPECT_EQ(refusal(target_of(0.0, 0.28, 20.0)), "synthetic motion: all targets must be positive");
  EXPECT_EQ(refusal(target_of(0.01, 0.04, 20.0)),
            "synthetic motion: the time step must be at most a tenth of the predominant period");
  EXPECT_EQ(refusal(target_of(0.5, 2.1, 20.0)),
            "synthetic motion: the duration must be at least ten predominant periods");
}

}  // namespace
}  // namespace moraine
