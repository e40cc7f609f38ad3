// Formulas of time.
#include <algorithm>
#include <string>

#include "motion/formula.hpp"
#include "motion/time_course.hpp"

namespace moraine {
namespace {

class FormulaCourse final : public TimeCourse::Rule {
 public:
  FormulaCourse(std::string const& text, double step) : step_(step), formula_(text, {"t"}) {}

  CourseState at(double time) const override {
    // The formula need not make sense before t = 0: near it the stencil stays behind.
    double const middle = std::max(time, 2.0 * step_);
    double const d = step_;
    double const here = value(middle);
    double const far_back = value(middle - 2.0 * d), back = value(middle - d);
    double const ahead = value(middle + d), far_ahead = value(middle + 2.0 * d);
    // Derivatives of the polynomial through the five, in units of d.
    double const first = (far_back - far_ahead + 8.0 * (ahead - back)) / 12.0;
    double const second = (16.0 * (back + ahead) - far_back - far_ahead - 30.0 * here) / 12.0;
    double const third = (far_ahead - far_back - 2.0 * (ahead - back)) / 2.0;
    double const fourth = far_back + far_ahead - 4.0 * (back + ahead) + 6.0 * here;
    double const s = (time - middle) / d;
    double const rate = first + s * (second + s * (third / 2.0 + s * fourth / 6.0));
    double const second_rate = second + s * (third + s * fourth / 2.0);
    return {value(time), rate / d, second_rate / (d * d)};
  }

 private:
  double value(double time) const { return formula_({&time, 1}); }

  double step_;  // s
  Formula formula_;
};

}  // namespace

TimeCourse TimeCourse::formula(std::string const& text, double step) {
  return TimeCourse(std::make_shared<FormulaCourse const>(text, step));
}

}  // namespace moraine
