#include "records/record_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace moraine {
namespace {

constexpr std::size_t told_one_by_one = 10;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n\f\v\x1a";
  auto const first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> words;
  for (;;) {
    auto const end = line.find(separator);
    words.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return words;
    line.remove_prefix(end + 1);
  }
}

/// From the start of `first` to the end of `second`, which follows it in the same text.
std::string_view joined(std::string_view first, std::string_view second) {
  return {first.data(), static_cast<std::size_t>(second.data() + second.size() - first.data())};
}

}  // namespace

std::vector<TextLine> lines_of(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<TextLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    auto const end = std::min(text.find('\n'), text.size());
    auto const line = trimmed(text.substr(0, end));
    if (!line.empty()) lines.push_back({number, line});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

bool is_text(std::string_view text) {
  constexpr std::string_view allowed = "\t\n\v\f\r\x1a";  // the last ends files of DOS
  return std::all_of(text.begin(), text.end(), [&](char c) {
    return static_cast<unsigned char>(c) >= 0x20 || allowed.find(c) != std::string_view::npos;
  });
}

std::string quoted_word(std::string_view word) {
  constexpr std::size_t most = 60;
  if (word.size() <= most) return fmt::format("\"{}\"", word);
  return fmt::format("\"{}...\"", word.substr(0, most));
}

bool is_comment(TextLine const& line) {
  return std::string_view("#%!").find(line.text.front()) != std::string_view::npos;
}

std::vector<std::string_view> words_of(std::string_view line) {
  for (char const separator : {';', '\t', ','}) {
    if (line.find(separator) == std::string_view::npos) continue;
    auto words = split(line, separator);
    if (words.size() > 1 && words.back().empty()) words.pop_back();  // "1, 2,"
    return words;
  }
  std::vector<std::string_view> words;
  for (auto const word : split(line, ' ')) {
    if (word.empty()) continue;
    if (!words.empty() && (word.front() == '(' || word.front() == '['))
      words.back() = joined(words.back(), word);
    else
      words.push_back(word);
  }
  return words;
}

std::optional<double> number_of(std::string_view word) {
  std::string text(word.starts_with('+') ? word.substr(1) : word);
  std::replace(text.begin(), text.end(), 'D', 'e');
  std::replace(text.begin(), text.end(), 'd', 'e');
  double value = 0.0;
  char const* const last = text.data() + text.size();
  auto const [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc{} || end != last || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool has_decimal_comma(std::string_view word, std::string_view line) {
  auto const comma = word.find(',');
  if (comma == std::string_view::npos)
    return word.size() > 1 && word.front() == '0' &&
           word.find_first_not_of("0123456789 ") == std::string_view::npos &&
           line.find(',') != std::string_view::npos;
  std::string with_point(word);
  with_point[comma] = '.';
  return number_of(with_point).has_value();
}

void RecordMistakes::add(std::size_t line, std::string value, std::string rule, std::string hint) {
  problems_.push_back({file_, line, line > 0 ? std::size_t{1} : 0, "", std::move(value),
                       std::move(rule), std::move(hint)});
}

void RecordMistakes::add_one_of_many(std::size_t line, std::string value, std::string rule,
                                     std::string kind) {
  auto found = std::find_if(kinds_.begin(), kinds_.end(),
                            [&](Kind const& known) { return known.name == kind; });
  if (found == kinds_.end()) found = kinds_.insert(found, Kind{std::move(kind)});
  found->last_line = line;
  if (++found->count <= told_one_by_one) add(line, std::move(value), std::move(rule));
}

void RecordMistakes::raise() const {
  if (problems_.empty()) return;
  std::vector<InputProblem> all = problems_;
  for (Kind const& kind : kinds_)
    if (kind.count > told_one_by_one)
      all.push_back({file_, kind.last_line, 1, "", "",
                     fmt::format("is the last of {} {}", kind.count, kind.name),
                     fmt::format("{} of them are not listed", kind.count - told_one_by_one)});
  throw InputErrors(std::move(all));
}

}  // namespace moraine
