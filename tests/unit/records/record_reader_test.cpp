#include "records/record_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/gravity.hpp"
#include "base/input_error.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

constexpr double g = standard_gravity;

std::string refusal(std::string const& text, RecordHints const& hints = {}) {
  return message_of<InputErrors>([&] { parse_record(text, "r.txt", hints); });
}

void expect_values(GroundRecord const& record, std::vector<double> const& expected, double unit) {
  ASSERT_EQ(record.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_DOUBLE_EQ(record.acceleration[i], expected[i] * unit) << i;
}

std::string at2(std::string const& last_header) {
  return "PEER STRONG MOTION DATABASE RECORD\n"
         "COALINGA 05/02/83, STATION\n"
         "ACCELERATION TIME HISTORY IN UNITS OF G\n" +
         last_header + "\n  .1000E-02  -.2000E-02   .3E-02\n   0.4E-02   0.5E-02\n";
}

// Both forms of the last header line, old and new.
TEST(RecordReader, ReadsAt2) {
  for (auto const* header : {"NPTS=   5, DT=   .0050 SEC", "NPTS=     5, DT=   .0050 SEC,",
                             "    5    0.0050    NPTS, DT"}) {
    GroundRecord const record = parse_record(at2(header), "folder/C-OLC360.AT2", {});
    EXPECT_EQ(record.name, "C-OLC360");
    EXPECT_EQ(record.time_step, 0.005);
    EXPECT_EQ(record.start, 0.0);
    expect_values(record, {0.001, -0.002, 0.003, 0.004, 0.005}, g);
  }
}

// The header of the older collection of PEER goes on after the unit, and others shout theirs.
TEST(RecordReader, ReadsUnitsInHeadersOfAt2) {
  struct Sample {
    char const* rest;
    double unit;
  };
  for (auto const& [rest, unit] :
       {Sample{"G. FILTER POINTS: HP=0.2 Hz LP=27.0 Hz", g}, Sample{"G, UNFILTERED", g},
        Sample{"G (FILTERED)", g}, Sample{"CM/S/S", 0.01}, Sample{"CM/SEC/SEC.", 0.01},
        Sample{"CM/SEC**2", 0.01}, Sample{"m/s2", 1.0}}) {
    std::string text = at2("NPTS= 5, DT= .0050 SEC");
    text.replace(text.find("UNITS OF G") + 9, 1, rest);
    expect_values(parse_record(text, "q.AT2", {}), {0.001, -0.002, 0.003, 0.004, 0.005}, unit);
  }
}

TEST(RecordReader, ReadsTwoColumnsWithUnits) {
  struct Sample {
    char const* heading;
    double unit;
  };
  for (auto const& [heading, unit] :
       {Sample{"t_s,a_g", g}, Sample{"time [s],acceleration [m/s^2]", 1.0},
        Sample{"t [s]; a (cm/s2)", 0.01}, Sample{"Time (s)\tAcc (g)", g},
        Sample{"time_s, ag_m_s2", 1.0}, Sample{"t (s)  acc [gal]", 0.01}}) {
    char const separator = std::string(heading).find_first_of(",;\t") == std::string::npos
                               ? ' '
                               : heading[std::string(heading).find_first_of(",;\t")];
    std::string text = std::string("# a comment\n") + heading + "\r\n";
    for (auto const* row : {"1.00*0.5", "1.02*-0.25", "1.04*1e-3"})
      text += std::string(row).replace(4, 1, 1, separator) + "\r\n";
    GroundRecord const record = parse_record(text, "quake.csv", {});
    EXPECT_NEAR(record.time_step, 0.02, 1e-15) << heading;
    EXPECT_EQ(record.start, 1.0);
    expect_values(record, {0.5, -0.25, 1e-3}, unit);
  }
}

TEST(RecordReader, ReadsTimesInOtherUnits) {
  GroundRecord const record = parse_record("t [ms],a [g]\n0,1\n5,2\n10,3\n", "q", {});
  EXPECT_DOUBLE_EQ(record.time_step, 0.005);
}

TEST(RecordReader, ReadsPlainNumbers) {
  RecordHints const hints{"cm/s2", 0.01};
  expect_values(parse_record("1\n2\n-3\n", "q", hints), {1, 2, -3}, 0.01);
  expect_values(parse_record("El Centro, N-S, gal\n1 2 +3D0 4\n5 6e0 7 8\n.9\n", "q", hints),
                {1, 2, 3, 4, 5, 6, 7, 8, 0.9}, 0.01);
  // Two numbers in a line are times only where they increase.
  expect_values(parse_record("1 2\n-3 4\n", "q", hints), {1, 2, -3, 4}, 0.01);
  expect_values(parse_record("\xEF\xBB\xBF"
                             "0.00 2\n0.01 4\n",
                             "q", {"g", 0.01}),
                {2, 4}, g);
}

// Times that were printed with few digits are still even.
TEST(RecordReader, ForgivesRoundedTimes) {
  std::string text = "t_s,a_g\n";
  for (int i = 0; i < 100; ++i) text += fmt::format("{:.3f},1\n", i / 60.0);
  EXPECT_NEAR(parse_record(text, "q", {}).time_step, 1.0 / 60.0, 1e-5);
}

TEST(RecordReader, TellsOfMissingUnitAndStep) {
  EXPECT_EQ(refusal("0.1\n-0.35\n"),
            "r.txt: does not say its time step; add --time-step \"0.01 s\"\n"
            "r.txt: does not say the unit of its acceleration (the largest value is 0.35); add "
            "--unit g, --unit m/s2 or --unit cm/s2");
  EXPECT_EQ(refusal("0.00 0.1\n0.01 0.2\n", {"furlong", {}}),
            "r.txt: unit \"furlong\" is no unit of acceleration; choose g, m/s2 or cm/s2");
  EXPECT_EQ(refusal("t_s,a_g\n0,1\n1,2\n", {"m/s2", 0.5}),
            "r.txt: time step 0.5 s is not what the file says, 1 s; leave out --time-step\n"
            "r.txt: unit \"m/s2\" is not what the file says, \"g\"; leave out --unit");
  EXPECT_EQ(refusal("1\n2\n", {"g", -1.0}), "r.txt: time step -1 s is not positive");
}

TEST(RecordReader, TellsOfGapsAndUnevenSteps) {
  EXPECT_EQ(refusal("t_s,a_g\n0.00,1\n0.01,2\n0.04,3\n0.05,4\n0.05,5\n0.06,6\n"),
            "r.txt:4:1: time 0.04 follows a gap of 0.03 s; the usual step is 0.01 s\n"
            "r.txt:6:1: time 0.05 does not come after the time before it");
  EXPECT_EQ(refusal("t_s,a_g\n0.000,1\n0.010,2\n0.024,3\n0.034,4\n0.044,5\n"),
            "r.txt:4:1: time 0.024 comes 0.014 s after the one before it, not 0.01 s");
}

TEST(RecordReader, TellsOfAllMistakesTogether) {
  std::string const text =
      "PEER\nVELOCITY TIME HISTORY IN UNITS OF CM/S\nNPTS= 7, DT= .0050 SEC\n"
      "0.1 x 0.3\n0.4 inf\n";
  EXPECT_EQ(
      refusal(text),
      "r.txt:2:1: \"VELOCITY TIME HISTORY IN UNITS OF CM/S\" does not speak of acceleration; "
      "give the record's .AT2 file\n"
      "r.txt:3:1: NPTS 7 is not the number of values, 5; the file is incomplete or its header "
      "is wrong\n"
      "r.txt:4:1: \"x\" is not a finite number\n"
      "r.txt:5:1: \"inf\" is not a finite number");
  EXPECT_EQ(
      refusal("IN UNITS OF G\nNPTS AND DT\n1 2\n"),
      "r.txt:2:1: \"NPTS AND DT\" does not hold the number of values and the time step; write "
      "NPTS= 4000, DT= .0050 SEC");
}

TEST(RecordReader, RefusesTimesWithoutEnd) {
  EXPECT_EQ(refusal("IN UNITS OF G\nNPTS= 4, 1e308 SEC\n1 2 3 4\n"),
            "r.txt: ground record: it must end before 1e12 s");
}

TEST(RecordReader, ListsTenOfAKind) {
  std::string text = "t_s,a_g\n";
  for (int i = 0; i < 25; ++i) text += fmt::format("{},{}\n", i, i % 2 == 0 ? "1" : "?");
  std::string const message = refusal(text);
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 10) << message;
  EXPECT_NE(message.find("r.txt:25:1: is the last of 12 words that are no numbers; 2 of them are "
                         "not listed"),
            std::string::npos)
      << message;
}

TEST(RecordReader, RefusesWhatIsNoRecord) {
  EXPECT_EQ(refusal(""), "r.txt: holds 0 values; a record has two or more");
  EXPECT_EQ(refusal("# nothing\n"), "r.txt: holds 0 values; a record has two or more");
  EXPECT_EQ(refusal("t_s,a_g\n0,1\n"),
            "r.txt: does not say its time step; add --time-step \"0.01 s\"");
  EXPECT_EQ(
      refusal("time [s],x [g],y [g]\n0,1,2\n1,2,3\n"),
      "r.txt:1:1: a table of 3 columns is no record; leave the time and one acceleration in it");
  EXPECT_EQ(refusal("t_s,a_g\n0,1\n1,2\n2\n3,4\n"),
            "r.txt:4:1: \"2\" is not a time and an acceleration");
  EXPECT_EQ(message_of<InputErrors>([] { read_record("/nowhere/quake.csv", {}); }),
            "/nowhere/quake.csv: does not exist");
  EXPECT_EQ(message_of<InputErrors>([] { read_record("/", {}); }), "/: is not a file");
}

// A decimal comma would split a number in two, and a record of other numbers be read.
TEST(RecordReader, RefusesDecimalCommas) {
  std::string const rule = " is not a finite number: decimals follow a point, not a comma";
  for (auto const* separator : {";", "\t"}) {
    std::string const row = std::string("0,01") + separator + "0,5\n";
    for (auto const& hints : {RecordHints{"g", {}}, RecordHints{"g", 0.01}})
      EXPECT_EQ(refusal(row + "0.02" + separator + "1\n", hints),
                "r.txt:1:1: \"0,01\"" + rule + "\nr.txt:1:1: \"0,5\"" + rule)
          << separator;
  }
  EXPECT_EQ(refusal("0,01\n0,35\n", {"g", 0.01}),
            "r.txt:1:1: \"0,01\" has commas inside of numbers: decimals follow a point\n"
            "r.txt:2:1: \"0,35\" has commas inside of numbers: decimals follow a point");
  EXPECT_EQ(refusal("0,01 1,5\n0,02 1,6\n", {"g", {}}),
            "r.txt:1:1: \"01 1\"" + rule + "\nr.txt:2:1: \"02 1\"" + rule);
}

// A velocity stays one, whatever unit of acceleration is told.
TEST(RecordReader, ReadsTwoWholeNumbersInALine) {
  expect_values(parse_record("1, 2\n-3, 4\n", "q", {"gal", 0.01}), {1, 2, -3, 4}, 0.01);
}

TEST(RecordReader, RefusesOtherQuantities) {
  std::string const rest =
      " is no acceleration; give the accelerations of the record, in a unit like g or m/s^2";
  for (auto const& hints : {RecordHints{}, RecordHints{"g", {}}}) {
    EXPECT_EQ(refusal("time (s),velocity (cm/s)\n0,1\n1,2\n", hints),
              "r.txt:1:1: \"velocity (cm/s)\"" + rest);
    EXPECT_EQ(refusal("t_s,d_m\n0,1\n1,2\n", hints), "r.txt:1:1: \"d_m\"" + rest);
  }
}

TEST(RecordReader, RefusesWhatIsNoText) {
  std::string const rule = "r.txt: is not a text; save it as plain text (UTF-8)";
  EXPECT_EQ(refusal(std::string("0.1\0000.2\n", 8), {"g", 0.01}), rule);
  EXPECT_EQ(refusal("0.1\n\x1b[2J\n", {"g", 0.01}), rule);
  expect_values(parse_record("1\r\n2\r\n\x1a", "q", {"g", 0.01}), {1, 2}, g);  // the end in DOS
  EXPECT_EQ(refusal("1\n" + std::string(5000, 'x') + "\n", {"g", 0.01}),
            "r.txt:2:1: \"" + std::string(60, 'x') + "...\" is not a finite number");
}

TEST(RecordReader, RefusesNumbersThatLeaveTheRange) {
  EXPECT_EQ(refusal("1e308\n1\n", {"g", 0.1}), "r.txt: ground record: a value is not finite");
  EXPECT_EQ(refusal("t_s,a_g\n-1e308,1\n1e308,2\n"),
            "r.txt: ground record: the time step must be positive");
}

TEST(RecordReader, KnowsUnits) {
  EXPECT_EQ(acceleration_unit("g"), g);
  EXPECT_EQ(acceleration_unit("m/s2"), 1.0);
  EXPECT_EQ(acceleration_unit("cm/s^2"), 0.01);
  EXPECT_EQ(acceleration_unit("gal"), 0.01);
  EXPECT_EQ(acceleration_unit("CM/S/S"), 0.01);
  EXPECT_EQ(acceleration_unit("cm/sec**2"), 0.01);
  EXPECT_FALSE(acceleration_unit("m/s"));
  EXPECT_FALSE(acceleration_unit(""));
  EXPECT_FALSE(acceleration_unit("kg"));
}

}  // namespace
}  // namespace moraine
