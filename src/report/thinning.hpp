// Which rows of a long table a report shows.
#pragma once

#include <cstddef>
#include <vector>

#include "output/table_csv.hpp"

namespace moraine::report {

/// At most about `most` rows, in ascending order: the first and the last, those in which any column
/// has its largest or smallest value, and of each piece of the rest the row that stands out most
/// from the straight line between the ends of the piece. All rows where there are no more than
/// `most`. Peaks are therefore never cut off, and every row shown is one that was written.
std::vector<std::size_t> shown_rows(Table const& table, std::size_t most);

}  // namespace moraine::report
