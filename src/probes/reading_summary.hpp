// What is left of a column of readings at the end of a run: extremes, arrival and integral.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "base/archive.hpp"

namespace moraine {

/// Extremes and integrals of one quantity over its readings. Readings that are not a number are
/// left out: they take no part in extremes, and nothing is integrated up to or from them.
class ReadingSummary {
 public:
  /// time in s, readings in ascending order of time.
  void add(double time, double value);

  bool seen() const { return !std::isnan(first_); }
  double first() const { return first_; }
  double largest() const { return largest_; }
  double time_of_largest() const { return time_of_largest_; }
  double smallest() const { return smallest_; }
  double time_of_smallest() const { return time_of_smallest_; }
  /// Integral over time by the trapezoidal rule [unit s].
  double integral() const { return integral_; }
  /// Integral of the difference to the first reading [unit s].
  double rise_integral() const { return rise_integral_; }
  /// First time at which the reading is `rise` above the first one, by linear interpolation between
  /// readings; not a number before. Set the rise before the first reading.
  double arrival() const { return arrival_; }
  void set_rise(double rise) { rise_ = rise; }
  /// Length of the positive phase [s]: from the arrival until the reading is back at the first one,
  /// for the first time after the largest, by linear interpolation. Not a number where there is no
  /// arrival, and where the readings end before. A later, larger reading begins the wait anew: the
  /// phase of the largest reading counts.
  double duration() const { return fall_back_ - arrival_; }

  /// `name`: a path of its own for this summary.
  void exchange(Archive& archive, std::string const& name);

 private:
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  double rise_ = nothing;
  double first_ = nothing;
  double last_ = nothing;
  double last_time_ = nothing;
  double largest_ = nothing, time_of_largest_ = nothing;
  double smallest_ = nothing, time_of_smallest_ = nothing;
  double arrival_ = nothing;
  double fall_back_ = nothing;  // s, when the first reading was met again after the largest
  double integral_ = 0.0;
  double rise_integral_ = 0.0;
};

}  // namespace moraine
