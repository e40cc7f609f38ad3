#include "records/processing.hpp"

#include <gtest/gtest.h>

#include "records/synthetic_motion.hpp"

namespace moraine {
namespace {

// Every step at once: what was asked for last still holds.
TEST(Processing, KeepsWhatWasAskedFor) {
  GroundRecord const record{"", 0.01, 0.0, white_noise(3001, 4)};
  Processing steps;
  steps.until = 25.0;
  steps.high_pass = 0.1;
  steps.low_pass = 20.0;
  steps.time_scale = 0.25;
  steps.time_step = 0.002;
  steps.baseline = Baseline::rest;
  steps.peak = 2.5;
  GroundRecord const result = processed(record, steps);
  EXPECT_EQ(result.time_step, 0.002);
  EXPECT_NEAR(result.duration(), 25.0 / 4.0, 0.002);
  EXPECT_EQ(peak_of(result, result.acceleration).value, 2.5);
  GroundPath const path = integrate(result);
  EXPECT_NEAR(path.velocity.back(), 0.0, 1e-12);
  EXPECT_NEAR(path.displacement.back(), 0.0, 1e-12);
}

// Corners count in the time of the file: filtering and scaling the time may not be exchanged.
TEST(Processing, FiltersBeforeItScalesTheTime) {
  GroundRecord const record{"", 0.01, 0.0, white_noise(2001, 4)};
  Processing steps;
  steps.low_pass = 10.0;
  steps.time_scale = 0.5;
  GroundRecord const expected =
      time_scaled(filtered(record, {Passband::low, 10.0, 2, Passes::both_ways}), 0.5);
  EXPECT_EQ(processed(record, steps).acceleration, expected.acceleration);
}

TEST(Processing, DoesNothingUnasked) {
  GroundRecord const record{"", 0.01, 0.5, white_noise(201, 4)};
  GroundRecord const same = processed(record, {});
  EXPECT_EQ(same.acceleration, record.acceleration);
  EXPECT_EQ(same.time_step, record.time_step);
  EXPECT_EQ(same.start, record.start);
}

}  // namespace
}  // namespace moraine
