#include "output/table_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "scratch_folder.hpp"

namespace moraine {
namespace {

using TableCsvTest = ScratchFolder;

TEST_F(TableCsvTest, WritesHeaderAndShortestNumbers) {
  TableCsv table(path("a.csv"), {{"time", "s"}, {"wall_right pressure", "Pa"}, {"particles", ""}});
  double const row[] = {0.1, 101325.0, 5000.0};
  table.add(row);
  // Read while the writer is alive: nothing may wait in a buffer.
  EXPECT_EQ(bytes_of(path("a.csv")),
            "time [s],wall_right pressure [Pa],particles\n0.1,101325,5000\n");
}

TEST_F(TableCsvTest, NumbersReadBackToTheSameDouble) {
  double const row[] = {1.0 / 3.0, -std::numeric_limits<double>::denorm_min(), 6.02214076e23,
                        std::numeric_limits<double>::max()};
  TableCsv(path("a.csv"), {{"a", ""}, {"b", "m"}, {"c", ""}, {"d", ""}}).add(row);
  Table const table = read_table_csv(path("a.csv"));
  ASSERT_EQ(table.rows(), 1U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(table.values[i][0], row[i]);
}

TEST_F(TableCsvTest, ReadsNotANumber) {
  double const row[] = {std::nan(""), std::numeric_limits<double>::infinity()};
  TableCsv(path("a.csv"), {{"a", ""}, {"b", ""}}).add(row);
  Table const table = read_table_csv(path("a.csv"));
  EXPECT_TRUE(std::isnan(table.values[0][0]));
  EXPECT_TRUE(std::isinf(table.values[1][0]));
}

TEST_F(TableCsvTest, QuotesNamesWithCommasAndQuotes) {
  TableCsv(path("a.csv"), {{"gauge \"A\", left", "Pa"}, {"b", ""}});
  EXPECT_EQ(bytes_of(path("a.csv")), "\"gauge \"\"A\"\", left [Pa]\",b\n");
  Table const table = read_table_csv(path("a.csv"));
  ASSERT_EQ(table.columns.size(), 2U);
  EXPECT_EQ(table.columns[0].name, "gauge \"A\", left");
  EXPECT_EQ(table.columns[0].unit, "Pa");
}

TEST(CsvField, IsQuotedWhereItMustBe) {
  EXPECT_EQ(csv_field("depth"), "depth");
  EXPECT_EQ(csv_field("crater, \"depth\""), "\"crater, \"\"depth\"\"\"");
}

TEST_F(TableCsvTest, LeavesOutARowCutOffByAKill) {
  write(path("a.csv"), "time [s],p [Pa]\n0,1\n1,2\n2,3");
  Table const table = read_table_csv(path("a.csv"));
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.find("p")->back(), 2.0);
  EXPECT_EQ(table.find("q"), nullptr);
}

TEST_F(TableCsvTest, ErrorsNameFileAndLine) {
  write(path("a.csv"), "time [s],p [Pa]\n0,1\n1,zwei\n");
  auto const bad = message_of<std::runtime_error>([&] { read_table_csv(path("a.csv")); });
  EXPECT_NE(bad.find("a.csv:3: expected 2 numbers, found '1,zwei'"), std::string::npos) << bad;
  auto const none = message_of<std::runtime_error>([&] { read_table_csv(path("none.csv")); });
  EXPECT_NE(none.find("cannot read table"), std::string::npos) << none;
}

TEST_F(TableCsvTest, RefusesARowOfTheWrongLength) {
  TableCsv table(path("a.csv"), {{"a", ""}, {"b", ""}});
  double const row[] = {1.0};
  EXPECT_THROW(table.add(row), std::invalid_argument);
}

TEST_F(TableCsvTest, RefusesAPlaceThatCannotBeWritten) {
  write(path("file"), "");
  EXPECT_THROW(TableCsv(path("file") / "a.csv", {{"a", ""}}), std::runtime_error);
}

}  // namespace
}  // namespace moraine
