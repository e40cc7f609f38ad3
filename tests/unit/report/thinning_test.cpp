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

bool holds(std::vector<std::size_t> const& rows, std::size_t row) {
  return std::find(rows.begin(), rows.end(), row) != rows.end();
}

TEST(Thinning, KeepsAllOfAShortTable) {
  auto const rows = shown_rows(long_table(50, 3, 4), 50);
  ASSERT_EQ(rows.size(), 50u);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
}

TEST(Thinning, KeepsEndsAndExtremesOfEveryColumn) {
  auto const rows = shown_rows(long_table(100'000, 54'321, 77'777), 400);
  EXPECT_LE(rows.size(), 700u);
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
  EXPECT_TRUE(holds(shown_rows(table, 400), 60'001));
}

TEST(Thinning, LivesWithColumnsOfNothing) {
  Table table = long_table(1000, 1, 2);
  std::fill(table.values[2].begin(), table.values[2].end(),
            std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(holds(shown_rows(table, 100), 999));
}

}  // namespace
}  // namespace moraine::report
