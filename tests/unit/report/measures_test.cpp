#include "report/measures.hpp"

#include <gtest/gtest.h>

namespace moraine::report {
namespace {

using nlohmann::json;

TEST(ReportMeasures, HoldWhatTheSummaryHolds) {
  auto const summary = json::parse(R"({"gauges": [
    {"name": "near the wall", "seen": true,
     "columns": {"near the wall pressure": {"unit": "Pa", "first": 1, "largest": 5.5e6,
       "time_of_largest": 2e-4, "smallest": -1, "time_of_smallest": 0, "integral_over_time": 70,
       "impulse": 60, "arrival": 1e-4, "duration": null}}},
    {"name": "line", "seen": false,
     "columns": {"line[1] density": {"unit": "kg/m^3", "largest": null}},
     "decay": {"exponent": -1.13, "points": 5, "scatter": 0.02}}]})");
  Json const rows = measures_of(summary);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0], Json::parse(R"({"gauge": "near the wall", "column": "pressure", "unit": "Pa",
    "seen": true, "first": 1.0, "largest": 5.5e6, "time_of_largest": 2e-4, "smallest": -1.0,
    "time_of_smallest": 0.0, "integral_over_time": 70.0, "impulse": 60.0, "arrival": 1e-4,
    "duration": null})"));
  EXPECT_EQ(rows[1]["column"], "line[1] density");
  EXPECT_EQ(rows[1]["seen"], false);
  EXPECT_TRUE(rows[1]["impulse"].is_null());
  EXPECT_EQ(decays_of(summary), Json::parse(R"([{"gauge": "line", "exponent": -1.13,
    "points": 5.0, "scatter": 0.02}])"));
}

TEST(ReportMeasures, AreWithoutWhatIsNone) {
  for (char const* const text :
       {"null", "[]", "{}", R"({"gauges": 3})", R"({"gauges": "P1"})",
        R"({"gauges": [1, null, []]})", R"({"gauges": {"P1": {"name": 4}}})",
        R"({"gauges": [{"name": "P1"}]})",
        R"({"gauges": [{"name": "P1", "columns": [1], "decay": 2}]})",
        R"({"gauges": [{"name": "P1", "columns": {"P1 pressure": 7}, "decay": []}]})"}) {
    EXPECT_EQ(measures_of(json::parse(text)), Json::array()) << text;
    EXPECT_EQ(decays_of(json::parse(text)), Json::array()) << text;
  }
}

TEST(ReportMeasures, TakeOddValuesForNone) {
  auto const summary = json::parse(R"({"gauges": [{"name": "P1", "seen": "yes", "columns":
    {"P1 ": {"unit": 5, "largest": "1e9", "first": [2], "impulse": true, "arrival": {}}},
    "decay": {"exponent": "steep"}}]})");
  Json const row = measures_of(summary).at(0);
  EXPECT_EQ(row["unit"], "");
  EXPECT_EQ(row["seen"], true);
  for (char const* const measure : {"largest", "first", "impulse", "arrival"})
    EXPECT_TRUE(row[measure].is_null()) << measure;
  EXPECT_TRUE(decays_of(summary).at(0)["exponent"].is_null());
}

}  // namespace
}  // namespace moraine::report
