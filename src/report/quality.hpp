// The first thing a reader of a report should see: can this run be trusted?
#pragma once

#include <string>
#include <string_view>

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

enum class Verdict { good, doubtful, bad, unknown };
std::string_view verdict_name(Verdict verdict);

/// Rows of the type Quality: how the run ended, conservation of energy and momentum, lost
/// particles, what the guards have seen, smoothing lengths that were cut off, gauges that saw
/// nothing, files that could not be read.
///
/// - energy: kinetic + internal + potential + lost, less what was booked (wall work, damping,
///   detonation, drift), against its value at the start; by the largest change of any of the three
///   kinds. Good below 1 %, bad from 5 % on. Unknown with gravity along periodic sides.
/// - momentum: its change against the impulses of walls and gravity, by the momentum that the
///   largest kinetic energy stands for, sqrt(2 m E). Good below 0.1 %, bad from 1 % on. Unknown
///   where damping or lost particles take momentum along; axes with symmetry planes do not count.
/// - lost particles: good where there are none.
/// - guards: the largest part of the bound that stops a run. Doubtful from 50 % on, and where one
/// was
///   switched off; unknown where it cannot see what it looks for.
/// Sums and parts that are no numbers are bad.
Json quality_of(RunFiles const& run);

}  // namespace moraine::report
