#include "records/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/records.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

/// Largest difference from sin(2 pi f t), and the largest value, away from the ends.
struct Likeness {
  double difference = 0.0, largest = 0.0;
};

Likeness likeness(GroundRecord const& record, double frequency) {
  Likeness result;
  for (std::size_t i = record.size() / 4; i < 3 * record.size() / 4; ++i) {
    double const exact = std::sin(2.0 * std::numbers::pi * frequency * record.time(i));
    result.difference = std::max(result.difference, std::fabs(record.acceleration[i] - exact));
    result.largest = std::max(result.largest, std::fabs(record.acceleration[i]));
  }
  return result;
}

// Waves that both steps hold come out as they were: up to 0.8 of half of one over the coarser step.
TEST(Resample, KeepsWavesThatBothStepsHold) {
  for (double const step : {0.004, 0.007, 0.01, 0.02, 0.025})
    for (double const part : {0.1, 0.5, 0.8}) {
      double const f = part * 0.5 / std::max(step, 0.01);
      GroundRecord const record = sine_record(1.0, f, 40.0, 0.01);
      GroundRecord const other = resampled(record, step, Interpolation::band_limited);
      EXPECT_EQ(other.time_step, step);
      EXPECT_LT(likeness(other, f).difference, 1e-4) << step << ' ' << f;
    }
}

// Waves above half of one over the coarser step would come back as false slow ones: they are gone.
TEST(Resample, LeavesOutWhatTheStepCannotHold) {
  for (double const part : {1.0, 1.3, 1.9}) {
    double const f = part * 0.5 / 0.04;
    GroundRecord const record = sine_record(1.0, f, 40.0, 0.01);
    EXPECT_LT(likeness(resampled(record, 0.04, Interpolation::band_limited), f).largest, 1e-4) << f;
  }
}

TEST(Resample, FinerStepsKeepTheOldValues) {
  GroundRecord const record = sine_record(2.0, 7.3, 5.0, 0.01);
  for (auto const way : {Interpolation::band_limited, Interpolation::linear}) {
    GroundRecord const finer = resampled(record, 0.0025, way);
    ASSERT_EQ(finer.size(), 4 * (record.size() - 1) + 1);
    for (std::size_t i = 0; i < record.size(); ++i)
      EXPECT_NEAR(finer.acceleration[4 * i], record.acceleration[i], 1e-12);
  }
}

TEST(Resample, StraightLinesAreStraight) {
  GroundRecord const record{"", 1.0, 3.0, {0.0, 2.0, -2.0}};
  GroundRecord const finer = resampled(record, 0.25, Interpolation::linear);
  EXPECT_EQ(finer.acceleration,
            (std::vector<double>{0.0, 0.5, 1.0, 1.5, 2.0, 1.0, 0.0, -1.0, -2.0}));
  EXPECT_EQ(finer.start, 3.0);
}

TEST(Resample, RefusesStepsThatDoNotFit) {
  GroundRecord const record = sine_record(1.0, 1.0, 1.0, 0.1);
  auto const refusal = [&](double step, Interpolation way) {
    return message_of<std::invalid_argument>([&] { resampled(record, step, way); });
  };
  char const* const fit = "resampling: the step must be positive and fit into the record";
  EXPECT_EQ(refusal(0.0, Interpolation::linear), fit);
  EXPECT_EQ(refusal(1.1, Interpolation::band_limited), fit);
  EXPECT_EQ(refusal(0.2, Interpolation::linear),
            "resampling: straight lines are for finer steps only");
}

}  // namespace
}  // namespace moraine
