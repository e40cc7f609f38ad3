// Doubts about how many neighbours particles have.
#pragma once

#include <vector>

#include "base/input_error.hpp"
#include "setup/case.hpp"

namespace moraine {

/// Mean number of lattice points within `reach` spacings: 2 r, pi r^2, 4/3 pi r^3.
double neighbours_within(double reach, int dimension);

/// Adds warnings about the smoothing length: too few neighbours, far too many, pairs under the
/// cubic spline, for the spacing of the case and for those of regions with a lattice of their own;
/// about products of explosives whose smoothing length stays while they expand; and about boxes
/// that are no whole number of their spacings long, whose mass is then another.
void add_smoothing_warnings(Case const& c, std::vector<InputProblem>& warnings);

}  // namespace moraine
