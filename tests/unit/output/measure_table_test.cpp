#include "output/motion/measure_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/gravity.hpp"
#include "output/motion/common_times.hpp"
#include "output/motion/motion_pictures.hpp"
#include "output/text_columns.hpp"
#include "support/records.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

class MotionTable : public ScratchFolder {};

std::vector<MeasuredMotion> two_motions() {
  GroundRecord a = sine_record(0.35 * standard_gravity, 2.5, 10.0, 0.01);
  GroundRecord b = sine_record(1.0, 1.0, 12.0, 0.005);
  a.name = "first";
  b.name = "second, \"longer\"";
  return {measured_motion(a), measured_motion(b)};
}

TEST_F(MotionTable, SaysTheSameInAllForms) {
  auto const motions = two_motions();
  auto const json = measures_as_json(motions);
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0].at("name"), "first");
  EXPECT_EQ(json[1].at("values"), 2401);
  EXPECT_EQ(json[0].at("peak_acceleration_m_s2"), motions[0].measures.acceleration.value);
  EXPECT_EQ(json[1].at("arias_intensity_m_s"), motions[1].measures.arias_intensity);
  std::istringstream csv(measures_as_csv(motions));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "measure,unit,first,\"second, \"\"longer\"\"\"");
  int rows = 0;
  bool found = false;
  for (; std::getline(csv, line); ++rows)
    found = found || line.starts_with("peak acceleration PGA,g,0.35,0.1019716");
  EXPECT_TRUE(found);
  EXPECT_EQ(static_cast<std::size_t>(rows) + 2, json[0].size());
  std::string const text = measures_as_text(motions);
  EXPECT_NE(text.find("\npeak acceleration PGA                g         0.35             0.102\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), rows + 1);
}

TEST_F(MotionTable, ColumnsCountLettersAndNotBytes) {
  TextColumns table({"a"});
  table.add_column("b");
  table.add_row({"m²/s", "1"});
  table.add_row({"xxxx", "22"});
  table.add_row({"y"});
  EXPECT_EQ(table.text(), "a      b\nm²/s   1\nxxxx  22\ny\n");
}

TEST_F(MotionTable, CommonTimesHoldAllRecords) {
  GroundRecord a{"", 0.5, 1.0, {0.0, 1.0, 2.0}}, b{"", 0.25, 0.0, {0.0, 4.0}};
  auto const times = common_times({a, b});
  ASSERT_EQ(times.size(), 9u);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times.back(), 2.0);
  auto const values = at_times(a, a.acceleration, times);
  EXPECT_TRUE(std::isnan(values[3]));
  EXPECT_EQ(values[4], 0.0);
  EXPECT_EQ(values[5], 0.5);
  EXPECT_EQ(values[8], 2.0);
  EXPECT_TRUE(std::isnan(at_times(b, b.acceleration, times)[2]));
}

TEST_F(MotionTable, DrawsThreePicturesAndWritesSpectra) {
  auto const motions = two_motions();
  std::vector<GroundRecord> const records{motions[0].record, motions[1].record};
  auto const files = draw_motions(path("m.svg"), records, {});
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[1].filename(), "m-spectra.svg");
  EXPECT_EQ(files[2].filename(), "m-frequencies.svg");
  for (auto const& file : files) EXPECT_GT(bytes_of(file).size(), 5000u);
  std::string const frequencies = frequencies_as_csv(records);
  EXPECT_TRUE(frequencies.starts_with("first frequency [Hz],first Fourier amplitude [m/s],"));
  // Twice the 2401 values, on to a length of small factors: 4860.
  EXPECT_EQ(std::count(frequencies.begin(), frequencies.end(), '\n'), 4860 / 2 + 2);
  std::string const csv = spectra_as_csv(records, {});
  EXPECT_TRUE(csv.starts_with("period [s],first displacement [m],first velocity [m/s]"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 401);
}

}  // namespace
}  // namespace moraine
