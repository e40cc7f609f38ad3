// Doubts about the physics of a case: what is allowed, but probably not meant.
#pragma once

#include <vector>

#include "base/input_error.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// Looks at a case and at its start:
/// - point gauges farther than the kernel support 2h from all fluid, fronts of absent materials;
/// - regions and solid walls thinner than the kernel support;
/// - reference sound speeds of Tait liquids below ten times, or above a hundred times, the speed to
///   expect: the largest of the initial speeds, sqrt(2 g H) for the fall from the top of the fluid
///   to its bottom, or to a lower wall, and sqrt(2 p / rho_0) for the largest initial pressure.
///   Density varies by about (v / c_0)^2; Monaghan, J. Comput. Phys. 110 (1994) 399;
/// - smoothing factors that give fewer neighbours than 4, 12, 33 in 1D, 2D, 3D (5, 21, 57 are
///   usual; Liu and Liu (2003)), and those of the cubic spline above 1.5, where neighbours at rest
///   lie inside the inflection point of the kernel, q = 2/3, and may form pairs.
std::vector<InputProblem> warnings_at_start(Case const& c, Simulation const& simulation);

/// Adds doubts about intervals of output: longer than the run, shorter than a `time_step` [s], or
/// more than 10 000 frames.
void add_output_warnings(Case const& c, double time_step, std::vector<InputProblem>& warnings);

}  // namespace moraine
