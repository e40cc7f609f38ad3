// A run beside the reference values of its case.
#pragma once

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

/// Values of the case's references beside those of the run, as the type Comparison.
Json comparisons_of(RunFiles const& run);

/// Curves of the case's references, as the type Reference; a file that cannot be read
/// is left out and noted.
Json references_of(RunFiles& run, Block& block);

}  // namespace moraine::report
