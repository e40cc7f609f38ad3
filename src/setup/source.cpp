#include "setup/source.hpp"

#include <utility>

namespace moraine {
namespace {

constexpr std::size_t longest_excerpt = 60;

// Byte offset of a column; columns count characters, of which UTF-8 may need several bytes.
std::size_t offset_of(std::string_view line, std::size_t column) {
  std::size_t offset = 0;
  for (std::size_t passed = 1; passed < column && offset < line.size(); ++passed) {
    ++offset;
    while (offset < line.size() && (static_cast<unsigned char>(line[offset]) & 0xc0U) == 0x80U)
      ++offset;
  }
  return offset;
}

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    auto const end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    if (lines.back().ends_with('\r')) lines.back().pop_back();
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  return lines;
}

}  // namespace

Source::Source(std::string_view text, std::string_view file)
    : file_(file), lines_(split_lines(text)) {}

std::string Source::excerpt(Stretch place) const {
  if (place.line == 0 || place.line > lines_.size()) return {};
  std::string const& line = lines_[place.line - 1];
  auto const begin = offset_of(line, place.column);
  bool const one_line = place.end_line == place.line;
  auto const end = one_line ? offset_of(line, place.end_column) : line.size();
  std::string text = line.substr(begin, end - begin);
  if (one_line && text.size() <= longest_excerpt) return text;
  return text.substr(0, offset_of(text, longest_excerpt - 2)) + "...";
}

std::map<std::string, Place> Source::places() const {
  std::map<std::string, Place> all;
  for (auto const& [key, place] : places_) {
    bool const table = places_.upper_bound(key + '.') != places_.lower_bound(key + '/');
    all[key] = {place.line, place.column, table ? std::string{} : excerpt(place)};
  }
  return all;
}

void Source::report_value(std::string const& key, Stretch place, std::string rule,
                          std::string hint) {
  bad_.insert(key);
  problems_.push_back(
      {file_, place.line, place.column, key, excerpt(place), std::move(rule), std::move(hint)});
}

void Source::report_value(std::string const& key, std::string rule, std::string hint) {
  report_value(key, place_of(key), std::move(rule), std::move(hint));
}

void Source::report_key(std::string const& key, Stretch place, std::string rule, std::string hint) {
  bad_.insert(key);
  problems_.push_back({file_, place.line, place.column, key, {}, std::move(rule), std::move(hint)});
}

}  // namespace moraine
