// Which part of a large table a report shows.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "output/table_csv.hpp"

namespace moraine::report {

/// How much of a table is shown: columns without that of times.
struct TablePart {
  std::size_t columns = 0, rows = 0;
};

/// What a table takes: of a page, so that its numbers are counted as base64.
struct TableCost {
  double number = 0.0;  // bytes
  double column = 0.0;  // bytes beside its numbers
};

/// The part of a table of that size that fits into `bytes`: all columns while each may keep some
/// hundred rows, and otherwise fewer columns. Never more than some thousand rows, as many as a line
/// on a large screen has points. No columns where not one fits.
TablePart part_that_fits(TablePart const& whole, TableCost const& cost, std::size_t bytes);

/// At most `most` columns without that of times, in ascending order: those in `wanted`, then the
/// first of each gauge, then the second of each ... The points of a line are one gauge.
std::vector<std::size_t> shown_columns(Table const& table, std::size_t most,
                                       std::set<std::string> const& wanted = {});

/// At most `most` rows, in ascending order: the first and the last, those in which one of the
/// columns has its largest or smallest value - of the first columns only where `most` are too few
/// for all - and of each piece of the rest the row that stands out most from the straight line
/// between the ends of the piece. All rows where there are no more than `most`. Peaks are therefore
/// not cut off, and every row shown is one that was written.
std::vector<std::size_t> shown_rows(Table const& table, std::vector<std::size_t> const& columns,
                                    std::size_t most);

/// The gauge that a column belongs to: names of gauges may hold blanks, those of quantities not.
/// Empty where the label has no blank.
std::string gauge_of(std::string const& label);

}  // namespace moraine::report
