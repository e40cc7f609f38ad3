// A quantity over time, computed or measured.
#pragma once

#include <string_view>
#include <vector>

#include "output/table_csv.hpp"

namespace moraine {

/// Readings in ascending order of time, linear between them. What is not a number, water that is
/// not there yet, counts as zero.
class Course {
 public:
  Course(std::vector<double> time, std::vector<double> value);
  /// Two columns of a table. Throws std::invalid_argument where it has them not.
  Course(Table const& table, std::string_view time, std::string_view name);

  /// Not a number outside of the readings.
  double at(double time) const;
  /// First time after `after` at which a value is reached; not a number where it never is.
  double arrival(double value, double after = 0.0) const;
  /// Over the readings between two times, by the trapezoidal rule.
  double integral(double from, double to) const;
  double largest() const;
  double end() const { return time_.back(); }

 private:
  double slope(std::size_t k) const;

  std::vector<double> time_;
  std::vector<double> value_;
};

/// Root of the mean square of the difference at 1000 times from zero to `end`.
double rms_difference(Course const& a, Course const& b, double end);

}  // namespace moraine
