#include "records/record_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "records/baseline.hpp"
#include "records/motion_fit.hpp"
#include "records/record_reader.hpp"
#include "setup/motion_file.hpp"
#include "support/records.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class RecordWriter : public ScratchFolder {};

GroundRecord some_record() {
  GroundRecord record{"some", 0.005, 0.0, white_noise(1234, 5)};
  for (double& a : record.acceleration) a *= 1.3;
  return record;
}

TEST_F(RecordWriter, CsvReadsBackToTheSameNumbers) {
  GroundRecord const record = some_record();
  write(path("quake.csv"), record_as_csv(record));
  GroundRecord const back = read_record(path("quake.csv"), {});
  EXPECT_EQ(back.acceleration, record.acceleration);
  EXPECT_NEAR(back.time_step, record.time_step, 1e-17);
  EXPECT_EQ(back.name, "quake");
}

TEST_F(RecordWriter, At2ReadsBackToEightDigits) {
  GroundRecord const record = some_record();
  write(path("quake.AT2"), record_as_at2(record));
  GroundRecord const back = read_record(path("quake.AT2"), {});
  ASSERT_EQ(back.size(), record.size());
  EXPECT_EQ(back.time_step, record.time_step);
  for (std::size_t i = 0; i < record.size(); ++i)
    EXPECT_NEAR(back.acceleration[i], record.acceleration[i],
                5e-8 * std::fabs(record.acceleration[i]) + 1e-12);
}

// The motion of a wall: same displacements, and between them nearly the acceleration of the record;
// a natural spline through points at 1/100 of the period misses it by about (w dt)^2/12 = 3e-4.
TEST_F(RecordWriter, DisplacementIsAMotionOfWalls) {
  GroundRecord const record = baseline_corrected(sine_record(2.0, 1.0, 8.0, 0.01), Baseline::rest);
  write(path("motion.csv"), displacement_as_csv(record, "y"));
  FiledMotion const motion = read_motion_file(path("motion.csv"), 2);
  EXPECT_NEAR(motion.end, 8.0, 1e-12);
  GroundPath const ground = integrate(record);
  EXPECT_FALSE(motion.motion.translation[0].given());
  for (std::size_t i = 0; i < record.size(); i += 7)
    EXPECT_NEAR(motion.motion.translation[1].at(record.time(i)).value, ground.displacement[i],
                1e-13);
  for (std::size_t i = 50; i + 50 < record.size(); i += 7) {
    CourseState const state = motion.motion.translation[1].at(record.time(i));
    EXPECT_NEAR(state.second_rate, record.acceleration[i], 2.0 * 5e-4);
    EXPECT_NEAR(state.rate, ground.velocity[i], 1e-5);
  }
}

}  // namespace
}  // namespace moraine
