#include "report/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace moraine::report {
namespace {

/// A slow wave with one reading of 1000 in row `peak`, and a second column with its low at `low`.
Table long_table(std::size_t rows, std::size_t peak, std::size_t low) {
  Table table;
  table.columns = {{"time", "s"}, {"a", "Pa"}, {"b", "m"}};
  table.values.resize(3);
  for (std::size_t row = 0; row < rows; ++row) {
    auto const t = static_cast<double>(row);
    table.values[0].push_back(t);
    table.values[1].push_back(row == peak ? 1000.0 : std::sin(1e-3 * t));
    table.values[2].push_back(row == low ? -7.0 : 1.0);
  }
  return table;
}

std::vector<std::size_t> rows_of(Table const& table, std::size_t most) {
  return shown_rows(table, shown_columns(table, table.columns.size()), most);
}

/// `lines` points of a line with two columns each, and a gauge behind them.
Table wide_table(std::size_t lines) {
  Table table;
  table.columns = {{"time", "s"}};
  for (std::size_t i = 0; i < lines; ++i)
    for (char const* const name : {"] pressure", "] density"})
      table.columns.push_back({"line[" + std::to_string(i) + name, ""});
  table.columns.push_back({"a b pressure", "Pa"});
  table.columns.push_back({"a b density", ""});
  return table;
}

bool holds(std::vector<std::size_t> const& rows, std::size_t row) {
  return std::find(rows.begin(), rows.end(), row) != rows.end();
}

TEST(Thinning, KeepsAllOfAShortTable) {
  auto const rows = rows_of(long_table(50, 3, 4), 50);
  ASSERT_EQ(rows.size(), 50u);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
}

TEST(Thinning, KeepsEndsAndExtremesOfEveryColumn) {
  auto const rows = rows_of(long_table(100'000, 54'321, 77'777), 400);
  EXPECT_LE(rows.size(), 400u);
  EXPECT_GE(rows.size(), 300u);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  EXPECT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end()) << "each once";
  for (std::size_t const row : {0u, 99'999u, 54'321u, 77'777u})
    EXPECT_TRUE(holds(rows, row)) << row;
}

// A second peak, lower than the first, is no extreme of its column and must still be seen.
TEST(Thinning, KeepsWhatStandsOutOfItsPiece) {
  Table table = long_table(100'000, 10, 20);
  table.values[1][60'001] = 500.0;
  EXPECT_TRUE(holds(rows_of(table, 400), 60'001));
}

TEST(Thinning, LivesWithColumnsOfNothing) {
  Table table = long_table(1000, 1, 2);
  std::fill(table.values[2].begin(), table.values[2].end(),
            std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(holds(rows_of(table, 100), 999));
}

TEST(Thinning, OfManyColumnsStaysBelowItsRows) {
  Table table = long_table(8000, 10, 20);
  for (int k = 0; k < 2998; ++k) {
    table.columns.push_back({"c", ""});
    table.values.emplace_back(8000, 0.0);
    table.values.back()[static_cast<std::size_t>(2 * k + 1)] = 1.0;  // each has a row of its own
  }
  auto const rows = rows_of(table, 300);
  EXPECT_LE(rows.size(), 300u);
  for (std::size_t const row : {0u, 7999u, 10u, 20u})
    EXPECT_TRUE(holds(rows, row)) << "of the first columns: " << row;
  for (std::size_t most : {2u, 3u, 4u, 5u})
    EXPECT_LE(rows_of(table, most).size(), most + 1) << most;
}

TEST(Thinning, KeepsColumnsOfEveryGauge) {
  Table const table = wide_table(500);  // columns 1 to 1000 are of the line
  EXPECT_EQ(shown_columns(table, 3), (std::vector<std::size_t>{1, 2, 1001}));
  EXPECT_EQ(shown_columns(table, 4), (std::vector<std::size_t>{1, 2, 1001, 1002}));
  EXPECT_EQ(shown_columns(table, 2, {"line[499] density"}), (std::vector<std::size_t>{1, 1000}));
  EXPECT_EQ(shown_columns(table, 5000).size(), 1002u);
}

TEST(Thinning, LeavesOutRowsBeforeColumns) {
  TableCost const cost{5.0, 200.0};
  TablePart const part = part_that_fits({10, 100'000}, cost, 100'000);
  EXPECT_EQ(part.columns, 10u);
  EXPECT_GT(part.rows, 1000u);
  EXPECT_LE(10 * 200 + part.rows * (10 * 5 + 8), 100'000u);
  TablePart const wide = part_that_fits({3000, 8000}, cost, 600'000);
  EXPECT_EQ(wide.rows, 300u);
  EXPECT_GT(wide.columns, 300u);
  EXPECT_LE(wide.columns * (200 + 300 * 5), 600'000u);
  EXPECT_EQ(part_that_fits({3000, 8000}, cost, 1000).columns, 0u);
  EXPECT_EQ(part_that_fits({2, 7}, cost, 10'000).rows, 7u) << "all of them";
}

}  // namespace
}  // namespace moraine::report
