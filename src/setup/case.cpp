#include "setup/case.hpp"

#include <utility>

namespace moraine {

InputProblem problem_of(Case const& c, std::string const& key, std::string rule, std::string hint) {
  InputProblem problem{.file = c.file,
                       .line = 0,
                       .column = 0,
                       .key = key,
                       .value = "",
                       .rule = std::move(rule),
                       .hint = std::move(hint)};
  for (std::string part = key;;) {
    if (auto const found = c.places.find(part); found != c.places.end()) {
      problem.line = found->second.line;
      problem.column = found->second.column;
      if (part == key) problem.value = found->second.text;
      return problem;
    }
    auto const dot = part.rfind('.');
    if (dot == std::string::npos) return problem;
    part.resize(dot);
  }
}

}  // namespace moraine
