#include "output/text_columns.hpp"

#include <algorithm>

namespace moraine {
namespace {

std::size_t letters(std::string const& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // no continuation byte
  }));
}

}  // namespace

std::string TextColumns::text() const {
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < headings_.size(); ++k) {
    std::size_t width = letters(headings_[k]);
    for (auto const& row : rows_)
      if (k < row.size()) width = std::max(width, letters(row[k]));
    widths.push_back(width);
  }
  auto const line = [&](std::vector<std::string> const& cells) {
    std::string result;
    for (std::size_t k = 0; k < headings_.size(); ++k) {
      std::string const cell = k < cells.size() ? cells[k] : "";
      std::string const room(widths[k] - letters(cell), ' ');
      if (k > 0) result += "  ";
      result += k < left_ ? cell + room : room + cell;
    }
    return result.substr(0, result.find_last_not_of(' ') + 1) + '\n';
  };
  std::string result = line(headings_);
  for (auto const& row : rows_) result += line(row);
  return result;
}

std::string quoted_cell(std::string const& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char const c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace moraine
