// A plane slab of TNT on soil, beside the exact solution of its Riemann problem.
#pragma once

#include <vector>

#include "exact/riemann.hpp"
#include "setup/case.hpp"
#include "verify/check.hpp"

namespace moraine {

/// The soil under uniaxial strain.
Law law_along_axis(MaterialSpec const& soil);

/// Products of TNT, burnt at once, beside soil at rest.
RiemannProblem slab_solution(MaterialSpec const& soil);

/// Arrival 15 cm inside the ground, and the plateau of stress behind the shock.
void add_slab(char const* soil, double spacing, std::vector<CheckResult>& results);

}  // namespace moraine
