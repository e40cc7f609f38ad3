#include "verify/course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "verify/gauge_table.hpp"

namespace moraine {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Course::Course(std::vector<double> time, std::vector<double> value)
    : time_(std::move(time)), value_(std::move(value)) {
  for (double& v : value_)
    if (std::isnan(v)) v = 0.0;
}

Course::Course(Table const& table, std::string_view time, std::string_view name)
    : Course(column(table, time), column(table, name)) {}

double Course::slope(std::size_t k) const {
  return (value_[k] - value_[k - 1]) / (time_[k] - time_[k - 1]);
}

double Course::at(double time) const {
  for (std::size_t k = 1; k < time_.size(); ++k)
    if (time_[k] >= time && time_[k - 1] <= time)
      return value_[k - 1] + slope(k) * (time - time_[k - 1]);
  return nothing;
}

double Course::arrival(double value, double after) const {
  for (std::size_t k = 1; k < time_.size(); ++k)
    if (time_[k - 1] >= after && value_[k - 1] < value && value_[k] >= value)
      return time_[k - 1] + (value - value_[k - 1]) / slope(k);
  return nothing;
}

double Course::integral(double from, double to) const {
  double sum = 0.0;
  for (std::size_t k = 1; k < time_.size(); ++k)
    if (time_[k - 1] >= from && time_[k] <= to)
      sum += 0.5 * (value_[k] + value_[k - 1]) * (time_[k] - time_[k - 1]);
  return sum;
}

double Course::largest() const { return *std::max_element(value_.begin(), value_.end()); }

double rms_difference(Course const& a, Course const& b, double end) {
  constexpr int samples = 1000;
  double sum = 0.0;
  for (int k = 0; k < samples; ++k) {
    double const time = end * (k + 0.5) / samples;
    sum += std::pow(a.at(time) - b.at(time), 2);
  }
  return std::sqrt(sum / samples);
}

}  // namespace moraine
