#include "verify/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace moraine {
namespace {

std::string verdict(CheckResult const& result, Colour colour) {
  std::string const word = result.pass ? "pass" : result.skipped ? "skip" : "FAIL";
  if (colour == Colour::none) return word;
  return fmt::format("\033[{}m{}\033[0m", result.pass ? 32 : result.skipped ? 33 : 31, word);
}

std::string line_of(CheckResult const& result, std::size_t width, Colour colour) {
  std::string const start =
      fmt::format("{}  {:<{}}  ", verdict(result, colour), result.name, width);
  if (result.skipped) return start + result.note + "\n";
  return start + fmt::format("{:>11.5g}  reference {:>9.4g} +- {:<8.3g} {:<6}  {}\n",
                             result.measured, result.reference, result.tolerance, result.unit,
                             result.note);
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
  for (CheckResult const& result : results) text += line_of(result, width, colour);
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
                    {"skipped", result.skipped},
                    {"note", result.note}});
  return list;
}

std::string summary(std::span<CheckResult const> results) {
  std::size_t passed = 0, measured = 0;
  std::string failed, skipped;
  auto const add = [](std::string& list, std::string const& name) {
    list += (list.empty() ? "" : ", ") + name;
  };
  for (CheckResult const& result : results) {
    if (result.pass) ++passed;
    if (!result.skipped) ++measured;
    if (result.failed()) add(failed, result.name);
    if (result.skipped) add(skipped, result.name);
  }
  std::string text = fmt::format("{} of {} results pass", passed, measured);
  if (!failed.empty()) text += "; not: " + failed;
  if (!skipped.empty()) text += "; skipped: " + skipped;
  return text;
}

}  // namespace moraine
