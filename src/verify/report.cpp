#include "verify/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace moraine {
namespace {

std::string verdict(CheckResult const& result, Colour colour) {
  std::string const word = result.pass ? "pass" : "FAIL";
  if (colour == Colour::none) return word;
  return fmt::format("\033[{}m{}\033[0m", result.pass ? 32 : 31, word);
}

nlohmann::ordered_json number_or_null(double value) {
  if (std::isfinite(value)) return value;
  return nullptr;
}

}  // namespace

std::string results_table(std::span<CheckResult const> results, Colour colour) {
  std::size_t width = 0;
  for (CheckResult const& result : results) width = std::max(width, result.name.size());
  std::string text;
  for (CheckResult const& result : results)
    text += fmt::format("{}  {:<{}}  {:>11.5g}  reference {:>9.4g} +- {:<8.3g} {:<6}  {}\n",
                        verdict(result, colour), result.name, width, result.measured,
                        result.reference, result.tolerance, result.unit, result.note);
  return text;
}

nlohmann::ordered_json to_json(std::span<CheckResult const> results) {
  auto list = nlohmann::ordered_json::array();
  for (CheckResult const& result : results)
    list.push_back({{"name", result.name},
                    {"measured", number_or_null(result.measured)},
                    {"reference", number_or_null(result.reference)},
                    {"tolerance", number_or_null(result.tolerance)},
                    {"unit", result.unit},
                    {"pass", result.pass},
                    {"note", result.note}});
  return list;
}

std::string summary(std::span<CheckResult const> results) {
  std::size_t passed = 0;
  std::string failed;
  for (CheckResult const& result : results) {
    if (result.pass)
      ++passed;
    else
      failed += (failed.empty() ? "" : ", ") + result.name;
  }
  std::string const count = fmt::format("{} of {} results pass", passed, results.size());
  return failed.empty() ? count : count + "; not: " + failed;
}

}  // namespace moraine
