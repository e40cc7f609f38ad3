// The table of where the time went, for the end of a run.
#pragma once

#include <string>

#include "base/timer.hpp"

namespace moraine {

/// Lines `label  seconds  %  calls`, longest first, ending with "other" (what no label covers) and
/// "total". Percentages are of `wall_seconds` [s], the wall time of everything that was to be
/// timed; labels are expected not to overlap, otherwise "other" is left out.
std::string timing_table(Timers const& timers, double wall_seconds);

}  // namespace moraine
