// Tables of a run.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

/// The tables "gauges" and "sums" as type Table of the format, those without rows left out.
struct Curves {
  Json tables = Json::array();
  Blocks blocks;
  std::vector<std::string> notes;  // which columns are left out
  bool whole = true;               // every row of every column
  std::size_t bytes() const;       // in the page
};

/// As much of the tables as fits into `bytes` of the page (thinning.hpp).
Curves curves_of(RunFiles const& run, std::size_t bytes);

}  // namespace moraine::report
