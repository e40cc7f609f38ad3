// A number that is prescribed as a function of time.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace moraine {

/// A prescribed number at an instant, with its first and second derivative in time.
struct CourseState {
  double value = 0.0;
  double rate = 0.0;         // 1/s of the value
  double second_rate = 0.0;  // 1/s^2 of the value
};

/// A function of time from 0 on; zero by default. Copies share an evaluator; one thread at a time.
class TimeCourse {
 public:
  TimeCourse() = default;

  /// A formula (motion/formula.hpp) of t [s], for example "0.05 * sin(2 * pi * 0.8 * t)".
  /// Derivatives are differences of fourth order over steps of `step` [s]; a kink is rounded over
  /// twice that time. Throws std::invalid_argument, with the place in the text, where it is no
  /// such formula.
  static TimeCourse formula(std::string const& text, double step);

  /// Values at times that increase, joined by a natural cubic spline: the second derivative is
  /// continuous. Before the first and after the last time the value stays. Throws
  /// std::invalid_argument for fewer than two times, numbers that are not finite, times that do not
  /// increase.
  static TimeCourse table(std::vector<double> times, std::vector<double> values);

  /// Whether it was made of a formula or a table.
  bool given() const { return rule_ != nullptr; }

  CourseState at(double time) const { return rule_ ? rule_->at(time) : CourseState{}; }

  struct Rule {
    virtual ~Rule() = default;
    virtual CourseState at(double time) const = 0;
  };

 private:
  explicit TimeCourse(std::shared_ptr<Rule const> rule) : rule_(std::move(rule)) {}
  std::shared_ptr<Rule const> rule_;
};

}  // namespace moraine
