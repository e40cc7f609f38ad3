// Tables of a run and the curves that belong beside them.
#pragma once

#include <cstddef>

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

/// The tables "gauges" and "sums" as type Table of the format, those without rows left out; with at
/// most about `most_rows` rows each.
Json tables_of(RunFiles const& run, std::size_t most_rows, Block& block);

}  // namespace moraine::report
