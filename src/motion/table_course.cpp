// Values at given times, joined by a natural cubic spline.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "motion/time_course.hpp"

namespace moraine {
namespace {

/// Second derivatives at the times, zero at both ends, by elimination in the tridiagonal system
///   l_k-1 M_k-1 + 2 (l_k-1 + l_k) M_k + l_k M_k+1 = 6 (slope_k - slope_k-1),  l_k = t_k+1 - t_k.
/// Source: de Boor, A Practical Guide to Splines (1978), chapter IV.
std::vector<double> bendings(std::vector<double> const& t, std::vector<double> const& y) {
  std::size_t const count = t.size();
  std::vector<double> bending(count, 0.0), pivot(count, 1.0);
  for (std::size_t k = 1; k + 1 < count; ++k) {
    double const before = t[k] - t[k - 1], after = t[k + 1] - t[k];
    double const carried = k > 1 ? before / pivot[k - 1] : 0.0;
    pivot[k] = 2.0 * (before + after) - carried * before;
    bending[k] =
        6.0 * ((y[k + 1] - y[k]) / after - (y[k] - y[k - 1]) / before) - carried * bending[k - 1];
  }
  for (std::size_t k = count - 1; k-- > 1;)
    bending[k] = (bending[k] - (t[k + 1] - t[k]) * bending[k + 1]) / pivot[k];
  bending.front() = 0.0;
  return bending;
}

class Spline final : public TimeCourse::Rule {
 public:
  Spline(std::vector<double> times, std::vector<double> values)
      : times_(std::move(times)), values_(std::move(values)), bending_(bendings(times_, values_)) {}

  CourseState at(double time) const override {
    if (time < times_.front()) return {values_.front()};
    if (time > times_.back()) return {values_.back()};
    auto const after = std::upper_bound(times_.begin(), times_.end() - 1, time);
    auto const k = static_cast<std::size_t>(after - times_.begin()) - 1;
    double const length = times_[k + 1] - times_[k];
    double const a = (times_[k + 1] - time) / length, b = 1.0 - a;
    double const low = bending_[k], high = bending_[k + 1];
    double const value =
        a * values_[k] + b * values_[k + 1] +
        length * length / 6.0 * ((a * a - 1.0) * a * low + (b * b - 1.0) * b * high);
    double const rate = (values_[k + 1] - values_[k]) / length +
                        length / 6.0 * ((3.0 * b * b - 1.0) * high - (3.0 * a * a - 1.0) * low);
    return {value, rate, a * low + b * high};
  }

 private:
  std::vector<double> times_, values_, bending_;
};

}  // namespace

TimeCourse TimeCourse::table(std::vector<double> times, std::vector<double> values) {
  if (times.size() < 2 || times.size() != values.size())
    throw std::invalid_argument("needs at least two times, each with a value");
  auto const finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(times.begin(), times.end(), finite) ||
      !std::all_of(values.begin(), values.end(), finite))
    throw std::invalid_argument("holds a number that is not finite");
  if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end())
    throw std::invalid_argument("has times that do not increase");
  return TimeCourse(std::make_shared<Spline const>(std::move(times), std::move(values)));
}

}  // namespace moraine
