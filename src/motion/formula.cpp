#include "motion/formula.hpp"

#include <muParser.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string_view>

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

/// muParser names the place in some of its messages only.
std::string with_position(mu::ParserError const& error) {
  std::string const message = error.GetMsg();
  bool const told = message.find("position") != std::string::npos || error.GetPos() < 0;
  return told ? message : message + " at position " + std::to_string(error.GetPos());
}

}  // namespace

struct Formula::Parts {
  std::vector<double> values;  // of the variables; the parser holds their places
  mu::Parser parser;
};

Formula::Formula(std::string const& text, std::vector<std::string> const& variables)
    : parts_(std::make_shared<Parts>()) {
  if (assigns(text)) throw std::invalid_argument("nothing can be assigned; compare with ==");
  mu::Parser& parser = parts_->parser;
  parts_->values.resize(variables.size());
  try {
    for (std::size_t k = 0; k < variables.size(); ++k)
      parser.DefineVar(variables[k], &parts_->values[k]);
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    parser.DefineConst("g0", 9.80665);
    parser.SetExpr(text);
    parser.Eval();
  } catch (mu::ParserError const& error) {
    throw std::invalid_argument(with_position(error));
  }
  if (parser.GetNumResults() != 1)
    throw std::invalid_argument("several formulas where one is expected");
}

std::vector<std::string> const& Formula::built_in_names() {
  static std::vector<std::string> const names = [] {
    std::vector<std::string> all{"pi", "e", "g0"};
    mu::Parser const parser;
    for (auto const& [name, ignored] : parser.GetFunDef()) all.push_back(name);
    for (auto const& [name, ignored] : parser.GetConst()) all.push_back(name);
    return all;
  }();
  return names;
}

double Formula::operator()(std::span<double const> values) const {
  std::copy_n(values.begin(), parts_->values.size(), parts_->values.begin());
  return parts_->parser.Eval();
}

}  // namespace moraine
