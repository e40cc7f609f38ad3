// Mistakes that only whole members have: values that contradict each other or the case.
#pragma once

#include <vector>

#include "base/input_error.hpp"
#include "setup/source.hpp"
#include "sweep/case_template.hpp"
#include "sweep/sweep_plan.hpp"

namespace moraine {

/// Checks the case of every member, with the state that it starts from. Each mistake is said once,
/// with the members that have it: at the place of the value that is wrong, or else, in the result,
/// without a place.
std::vector<InputProblem> check_members(SweepPlan const& plan, CaseTemplate const& cases,
                                        Source& source);

}  // namespace moraine
