// The members of a sweep: which values go together.
#pragma once

#include <vector>

#include "sweep/sweep_plan.hpp"

namespace moraine {

/// Number of members that a plan makes, as far as most_members + 1.
std::size_t count_members(SweepPlan const& plan);

/// All members in their order: of a grid, the values of the last axis change fastest. Axes with
/// one value have it in all members. Names are the number and the values that vary.
std::vector<SweepMember> make_members(SweepPlan const& plan);

}  // namespace moraine
