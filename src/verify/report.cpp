#include "verify/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace moraine {
namespace {

struct Word {
  char const* text;
  int colour;  // of a terminal: green, red, cyan, yellow
};

Word word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return {"pass", 32};
    case Verdict::fail:
      return {"FAIL", 31};
    case Verdict::known:
      return {"known", 36};
    case Verdict::skip:
      return {"skip", 33};
  }
  return {"", 0};
}

/// As wide as the longest of them.
std::string in_colour(Word const& word, Colour colour) {
  std::string const padded = fmt::format("{:<5}", word.text);
  if (colour == Colour::none) return padded;
  return fmt::format("\033[{}m{}\033[0m", word.colour, padded);
}

/// The reference and what is allowed of difference from it.
std::string expected(CheckResult const& result) {
  if (result.from_below) return fmt::format("at most   {:>9.4g}    {:<8}", result.reference, "");
  return fmt::format("reference {:>9.4g} +- {:<8.3g}", result.reference, result.tolerance);
}

/// Why a result that does not pass is no failure.
std::string excuse(CheckResult const& result) {
  if (result.verdict() != Verdict::known) return "";
  return fmt::format("; explained in {}, regression bound +- {:.3g}", result.explained_in,
                     result.worst);
}

std::string line_of(CheckResult const& result, std::size_t width, Colour colour) {
  std::string const start =
      fmt::format("{} {:<{}}  ", in_colour(word_of(result.verdict()), colour), result.name, width);
  if (result.skipped) return start + result.note + "\n";
  return start + fmt::format("{:>11.5g}  {} {:<6}  {}{}\n", result.measured, expected(result),
                             result.unit, result.note, excuse(result));
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
                    {"known", result.verdict() == Verdict::known},
                    {"from_below", result.from_below},
                    {"worst", number_or_null(result.explained_in.empty() ? NAN : result.worst)},
                    {"explained_in", result.explained_in},
                    {"note", result.note}});
  return list;
}

std::string summary(std::span<CheckResult const> results) {
  std::size_t passed = 0, measured = 0, known = 0;
  std::string failed, explained, skipped;
  auto const add = [](std::string& list, std::string const& name) {
    list += (list.empty() ? "" : ", ") + name;
  };
  for (CheckResult const& result : results) {
    Verdict const verdict = result.verdict();
    if (verdict == Verdict::pass) ++passed;
    if (verdict != Verdict::skip) ++measured;
    if (verdict == Verdict::fail) add(failed, result.name);
    if (verdict == Verdict::skip) add(skipped, result.name);
    if (verdict != Verdict::known) continue;
    ++known;
    add(explained, result.name);
  }
  std::string text = fmt::format("{} of {} results pass", passed, measured);
  if (!failed.empty()) text += "; not: " + failed;
  if (known > 0) text += fmt::format("; {} known and explained: {}", known, explained);
  if (!skipped.empty()) text += "; skipped: " + skipped;
  return text;
}

}  // namespace moraine
