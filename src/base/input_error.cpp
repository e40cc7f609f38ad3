#include "base/input_error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace moraine {
namespace {

std::vector<InputProblem> sorted(std::vector<InputProblem> problems) {
  std::stable_sort(problems.begin(), problems.end(), [](auto const& a, auto const& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  return problems;
}

std::string all_lines(std::vector<InputProblem> const& problems) {
  std::string text;
  for (auto const& problem : problems) {
    if (!text.empty()) text += '\n';
    text += format(problem);
  }
  return text;
}

// "wendland" abbreviates "wendland_c2", "sound_speed" abbreviates "reference_sound_speed".
bool abbreviates(std::string_view part, std::string_view whole) {
  if (part.size() < 3 || whole.size() <= part.size()) return false;
  bool const front = whole.starts_with(part) && whole[part.size()] == '_';
  bool const back = whole.ends_with(part) && whole[whole.size() - part.size() - 1] == '_';
  return front || back;
}

}  // namespace

std::string format(InputProblem const& problem) {
  std::string text = problem.file;
  if (problem.line > 0) text += fmt::format(":{}:{}", problem.line, problem.column);
  if (!text.empty()) text += ": ";
  if (!problem.key.empty()) text += problem.key + ": ";
  if (!problem.value.empty()) text += problem.value + ' ';
  text += problem.rule;
  if (!problem.hint.empty()) text += "; " + problem.hint;
  return text;
}

InputErrors::InputErrors(std::vector<InputProblem> problems)
    : std::runtime_error(all_lines(sorted(problems))), problems_(sorted(std::move(problems))) {}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      std::size_t const change = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::exchange(last, row);
  }
  return last[b.size()];
}

std::string_view nearest_name(std::string_view word, std::span<std::string_view const> names) {
  std::string_view best;
  std::size_t best_distance = 0;
  for (auto const name : names) {
    std::size_t const distance = edit_distance(word, name);
    std::size_t const allowed = std::max<std::size_t>(1, std::max(word.size(), name.size()) / 3);
    bool const telling = word.size() > 2 || name.size() > 2;  // "z+" resembles "x+" by chance
    if (distance <= allowed && telling && (best.empty() || distance < best_distance)) {
      best = name;
      best_distance = distance;
    }
  }
  if (!best.empty()) return best;
  auto const found = std::find_if(names.begin(), names.end(), [&](std::string_view name) {
    return abbreviates(word, name) || abbreviates(name, word);
  });
  return found == names.end() ? std::string_view{} : *found;
}

std::string name_hint(std::string_view word, std::span<std::string_view const> names) {
  if (auto const name = nearest_name(word, names); !name.empty())
    return fmt::format("did you mean \"{}\"?", name);
  std::string list;
  for (auto const name : names) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  return list.empty() ? list : "choose one of " + list;
}

}  // namespace moraine
