#include "records/ground_record.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/records.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

// a = 6 t is straight, so v = 3 t^2 and d = t^3 to rounding.
TEST(GroundRecord, StraightAccelerationIsIntegratedExactly) {
  GroundRecord const record = record_of(2.0, 0.125, [](double t) { return 6.0 * t; });
  GroundPath const path = integrate(record);
  for (std::size_t i = 0; i < record.size(); ++i) {
    double const t = record.time(i);
    EXPECT_NEAR(path.velocity[i], 3.0 * t * t, 1e-14);
    EXPECT_NEAR(path.displacement[i], t * t * t, 1e-14);
  }
}

TEST(GroundRecord, ScalesToThePeakToTheLastBit) {
  GroundRecord const record = scaled_to_peak(sine_record(-2.7, 1.3, 10.0, 0.01), 0.35 * 9.80665);
  EXPECT_EQ(peak_of(record, record.acceleration).value, 0.35 * 9.80665);
}

TEST(GroundRecord, TimeScaleMovesTimesAndNothingElse) {
  GroundRecord record = sine_record(1.0, 1.0, 4.0, 0.02);
  record.start = 0.5;
  GroundRecord const scaled = time_scaled(record, 0.25);
  EXPECT_EQ(scaled.acceleration, record.acceleration);
  EXPECT_EQ(scaled.time_step, 0.005);
  EXPECT_EQ(scaled.start, 0.125);
  EXPECT_DOUBLE_EQ(scaled.duration(), 1.0);
}

TEST(GroundRecord, IsCutAtATime) {
  GroundRecord const record = sine_record(1.0, 1.0, 4.0, 0.02);
  EXPECT_EQ(cut_after(record, 1.5).size(), 76u);
  EXPECT_EQ(cut_after(record, 1.519).size(), 76u);
  EXPECT_EQ(cut_after(record, 9.0).size(), record.size());
  EXPECT_EQ(message_of<std::invalid_argument>([&] { cut_after(record, 0.01); }),
            "cut record: fewer than two values are left");
}

TEST(GroundRecord, RefusesWhatIsNoRecord) {
  auto const refusal = [](GroundRecord const& record) {
    return message_of<std::invalid_argument>([&] { check_record(record); });
  };
  EXPECT_EQ(refusal({"", 0.01, 0.0, {1.0}}), "ground record: it must have two values or more");
  EXPECT_EQ(refusal({"", 0.0, 0.0, {1.0, 2.0}}), "ground record: the time step must be positive");
  EXPECT_EQ(refusal({"", 0.1, 0.0, {1.0, NAN}}), "ground record: a value is not finite");
  EXPECT_EQ(refusal({"", 0.1, 0.0, {1.0, 2.0}}), "");
  GroundRecord const still{"", 0.1, 0.0, {0.0, 0.0}};
  EXPECT_EQ(message_of<std::invalid_argument>([&] { scaled_to_peak(still, 1.0); }),
            "scaled record: it is zero throughout");
  EXPECT_EQ(message_of<std::invalid_argument>([&] { time_scaled(still, 0.0); }),
            "time scale: the factor must be positive");
}

}  // namespace
}  // namespace moraine
