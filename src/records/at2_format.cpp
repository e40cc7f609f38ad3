// PEER strong motion files: four header lines, then numbers, as
// https://ngawest2.berkeley.edu (PEER NGA database) hands them out.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "records/record_formats.hpp"

namespace moraine {
namespace {

constexpr std::size_t most_header_lines = 8;

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

/// All numbers in a text, whatever stands around them: of "NPTS= 4000, DT= .005 SEC" two.
std::vector<double> numbers_in(std::string text) {
  for (char& c : text)
    if (std::string_view("=,;:").find(c) != std::string_view::npos) c = ' ';
  std::vector<double> numbers;
  for (auto const word : words_of(text))
    if (auto const number = number_of(word)) numbers.push_back(*number);
  return numbers;
}

/// "G" of "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz LP=27.0 Hz".
std::string unit_in(std::string_view header) {
  constexpr std::string_view lead = "UNITS OF ";
  auto const place = upper(header).find(lead);
  if (place == std::string::npos) return {};
  std::string_view unit = header.substr(place + lead.size());
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  unit = unit.substr(0, unit.find_first_of(" ,;\t("));
  while (unit.ends_with('.') || unit.ends_with(':')) unit.remove_suffix(1);
  return std::string(unit);
}

}  // namespace

std::optional<std::size_t> at2_header_end(std::vector<TextLine> const& lines) {
  for (std::size_t i = 0; i < std::min(lines.size(), most_header_lines); ++i)
    if (upper(lines[i].text).find("NPTS") != std::string::npos) return i;
  return std::nullopt;
}

FiledRecord read_at2(std::vector<TextLine> const& lines, std::size_t header_end,
                     RecordMistakes& mistakes) {
  FiledRecord record;
  for (std::size_t i = 0; i < header_end; ++i) {
    std::string const line = upper(lines[i].text);
    if (record.unit.empty()) record.unit = unit_in(lines[i].text);
    for (auto const* other : {"VELOCITY", "DISPLACEMENT"})
      if (line.find(other) != std::string::npos && line.find("ACCELERATION") == std::string::npos) {
        record.another_quantity = true;
        mistakes.add(lines[i].number, quoted_word(lines[i].text), "does not speak of acceleration",
                     "give the record's .AT2 file");
      }
  }
  for (std::size_t i = header_end + 1; i < lines.size(); ++i)
    add_numbers(lines[i], record.values, mistakes);
  TextLine const& last = lines[header_end];
  auto const numbers = numbers_in(std::string(last.text));
  bool const whole = numbers.size() >= 2 && numbers[0] >= 0.0 && numbers[0] < 1e9 &&
                     std::floor(numbers[0]) == numbers[0];
  if (!whole || !(numbers[1] > 0.0)) {
    mistakes.add(last.number, quoted_word(last.text),
                 "does not hold the number of values and the time step",
                 "write NPTS= 4000, DT= .0050 SEC");
    return record;
  }
  record.time_step = numbers[1];
  if (static_cast<double>(record.values.size()) != numbers[0])
    mistakes.add(last.number, fmt::format("NPTS {:.0f}", numbers[0]),
                 fmt::format("is not the number of values, {}", record.values.size()),
                 "the file is incomplete or its header is wrong");
  return record;
}

}  // namespace moraine
