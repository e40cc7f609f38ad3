#include "records/baseline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "records/synthetic_motion.hpp"
#include "support/records.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

GroundRecord noise_record() { return {"noise", 0.01, 0.0, white_noise(1501, 11)}; }

GroundRecord with_drift(GroundRecord record, int degree) {
  for (std::size_t i = 0; i < record.size(); ++i) {
    double const t = record.time(i);
    record.acceleration[i] += 0.3 - 0.2 * (degree > 0) * t + 0.05 * (degree > 1) * t * t -
                              0.004 * (degree > 2) * t * t * t;
  }
  return record;
}

double largest_difference(GroundRecord const& a, GroundRecord const& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::fabs(a.acceleration[i] - b.acceleration[i]));
  return largest;
}

// A drift of the degree that is corrected goes without a trace; what has none stays as it is.
TEST(Baseline, TakesAwayAKnownDrift) {
  for (auto const way : {Baseline::mean, Baseline::linear, Baseline::quadratic, Baseline::cubic}) {
    int const degree = static_cast<int>(way) - static_cast<int>(Baseline::mean);
    GroundRecord const clean = baseline_corrected(noise_record(), way);
    EXPECT_LT(largest_difference(baseline_corrected(clean, way), clean), 1e-13);
    EXPECT_LT(largest_difference(baseline_corrected(with_drift(clean, degree), way), clean), 1e-12)
        << degree;
    if (degree < 3) {
      EXPECT_GT(largest_difference(baseline_corrected(with_drift(clean, 3), way), clean), 0.1);
    }
  }
}

TEST(Baseline, RestEndsAtRestInItsPlace) {
  GroundRecord const still = baseline_corrected(noise_record(), Baseline::rest);
  GroundPath const path = integrate(still);
  EXPECT_NEAR(path.velocity.back(), 0.0, 1e-12);
  EXPECT_NEAR(path.displacement.back(), 0.0, 1e-11);
  // A line that was added is found again.
  GroundRecord const again = baseline_corrected(with_drift(still, 1), Baseline::rest);
  EXPECT_LT(largest_difference(again, still), 1e-12);
}

TEST(Baseline, NoneChangesNothing) {
  EXPECT_EQ(baseline_corrected(noise_record(), Baseline::none).acceleration,
            noise_record().acceleration);
}

TEST(Baseline, RefusesRecordsThatAreTooShort) {
  GroundRecord const three{"", 0.1, 0.0, {1.0, 2.0, 4.0}};
  EXPECT_EQ(message_of<std::invalid_argument>([&] { baseline_corrected(three, Baseline::cubic); }),
            "baseline: the record is too short for this polynomial");
  EXPECT_NEAR(baseline_corrected(three, Baseline::quadratic).acceleration[1], 0.0, 1e-15);
}

}  // namespace
}  // namespace moraine
