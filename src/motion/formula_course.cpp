// Formulas of time.
#include <muParser.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>

#include "motion/time_course.hpp"

namespace moraine {
namespace {

/// Whether the text holds a lone =, which muParser takes for an assignment.
bool assigns(std::string_view text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '=') continue;
    if (k + 1 < text.size() && text[k + 1] == '=')
      ++k;
    else if (k == 0 || std::string_view("!<>").find(text[k - 1]) == std::string_view::npos)
      return true;
  }
  return false;
}

class Formula final : public TimeCourse::Rule {
 public:
  Formula(std::string const& text, double step) : step_(step) {
    if (assigns(text)) throw std::invalid_argument("nothing can be assigned; compare with ==");
    try {
      parser_.DefineVar("t", &time_);
      parser_.DefineConst("pi", std::numbers::pi);
      parser_.DefineConst("e", std::numbers::e);
      parser_.DefineConst("g0", 9.80665);
      parser_.SetExpr(text);
      parser_.Eval();
    } catch (mu::ParserError const& error) {
      throw std::invalid_argument(error.GetMsg());
    }
    if (parser_.GetNumResults() != 1)
      throw std::invalid_argument("several formulas where one is expected");
  }

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
  double value(double time) const {
    time_ = time;
    return parser_.Eval();
  }

  double step_;  // s
  mutable double time_ = 0.0;
  mu::Parser parser_;
};

}  // namespace

TimeCourse TimeCourse::formula(std::string const& text, double step) {
  return TimeCourse(std::make_shared<Formula const>(text, step));
}

}  // namespace moraine
