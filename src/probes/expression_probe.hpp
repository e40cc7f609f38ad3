// A formula over particles, reduced to one number.
#pragma once

#include <cstddef>

#include "probes/particle_formula.hpp"
#include "probes/reduction.hpp"
#include "probes/selection.hpp"

namespace moraine {

struct ReducedValue {
  double value = 0.0;
  std::size_t particles = 0;
};

/// A formula f over the selected particles, V = m / rho:
///
///   max f, min f, sum_i f_i, sum_i f_i V_i (the integral over their volume),
///   mean: sum_i w_i f_i / sum_i w_i with w = m, V or 1.
///
/// Where f is not a number for one particle, neither is the result. Without particles sum and
/// integral are zero, the others not numbers. h: smoothing length of all, where it is the same [m];
/// time in s.
ReducedValue reduce_formula(ParticleStore const& store, Selection const& selection,
                            ParticleFormula const& formula, Reduction reduction, MeanWeight weight,
                            double h, double time);

}  // namespace moraine
