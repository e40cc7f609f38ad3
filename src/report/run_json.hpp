// One run as the type Run of report/FORMAT.md.
#pragma once

#include <cstddef>

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

/// All of a run but its tables, which are empty, and its particles, which are null.
Json run_head(RunFiles& run, Blocks& blocks);

/// Tells the notes of the run from this one on, which came after its head was made.
void add_later_notes(Json& head, RunFiles const& run, std::size_t first);

}  // namespace moraine::report
