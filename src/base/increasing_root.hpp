// Zero of an increasing function of which the slope is known.
#pragma once

#include <cmath>

#include "base/macros.hpp"

namespace moraine {

/// Value and slope of a function of one variable.
struct ValueAndSlope {
  double value;
  double slope;
};

/// The zero of an increasing `f` between `low`, where it is not positive, and `high`, where it is
/// not negative. Ends with a step of Newton's method below `tolerance`, far more exact than that.
///
/// Newton's method, kept inside an interval that holds the zero: a step that would leave the
/// interval, or not halve the step before the last, is replaced by halving the interval. At most
/// 200 evaluations, usually three to six; for use inside a pass over particles.
template <class F>
MORAINE_HD double increasing_root(F const& f, double low, double high, double guess,
                                  double tolerance) {
  constexpr int most = 200;
  double x = guess >= low && guess <= high ? guess : low + 0.5 * (high - low);
  double before_last = high - low;
  double last = before_last;
  for (int k = 0; k < most; ++k) {
    ValueAndSlope const at = f(x);
    if (at.value == 0.0) return x;
    (at.value < 0.0 ? low : high) = x;
    double next = x - at.value / at.slope;
    if (std::fabs(next - x) <= tolerance) return next;
    bool const inside = next > low && next < high;
    if (!inside || !(2.0 * std::fabs(next - x) <= before_last)) next = low + 0.5 * (high - low);
    before_last = last;
    last = std::fabs(next - x);
    x = next;
    if (!(high - low > tolerance)) return x;
  }
  return x;
}

}  // namespace moraine
