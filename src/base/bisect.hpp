// Zero of a function of one variable by halving.
#pragma once

#include "base/macros.hpp"

namespace moraine {

/// A zero of `f` between `low` and `high`, to the last bit of the argument.
///
/// f(low) and f(high) must differ in sign (zero counts as either); otherwise the end of the
/// interval that is approached is meaningless. A function with several zeros gives one of them.
/// Takes at most about 1100 evaluations, 50 to 60 where low and high are of one magnitude; meant
/// for setup and for reference solutions.
template <class F>
MORAINE_HD double bisect(F const& f, double low, double high) {
  bool const low_is_negative = f(low) < 0.0;
  for (;;) {
    double const middle = low + 0.5 * (high - low);
    if (middle == low || middle == high) return middle;
    double& same_side = (f(middle) < 0.0) == low_is_negative ? low : high;
    same_side = middle;
  }
}

}  // namespace moraine
