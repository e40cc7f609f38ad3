// A formula that a case file holds as text.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace moraine {

/// A number as a function of variables, in the language of muParser (operators + - * / ^,
/// comparisons, a ? b : c, sin, cos, tan, exp, log, sqrt, abs, min, max, ...) with the constants
/// pi, e and g0 = 9.80665. Copies share an evaluator; one thread at a time.
class Formula {
 public:
  /// Throws std::invalid_argument, with the place in the text, where it is no such formula.
  Formula(std::string const& text, std::vector<std::string> const& variables);

  /// Names of all functions and constants that any formula may use.
  static std::vector<std::string> const& built_in_names();

  /// `values` in the order of the variables, none may be missing.
  double operator()(std::span<double const> values) const;

 private:
  struct Parts;
  std::shared_ptr<Parts> parts_;
};

}  // namespace moraine
