// One run as the type Run of report/FORMAT.md.
#pragma once

#include <cstddef>

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

/// All of a run but its particles, which are null. Tables have at most about `most_rows` rows.
Json run_json(RunFiles& run, std::size_t most_rows, Blocks& blocks);

}  // namespace moraine::report
