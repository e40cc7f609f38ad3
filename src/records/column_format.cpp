// Records as plain text: two columns of time and acceleration, or accelerations alone.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/units.hpp"
#include "records/record_formats.hpp"

namespace moraine {
namespace {

/// "acceleration [m/s^2]", "a (g)", "a_m_s2": a name and the unit it carries, if any.
struct Heading {
  std::string_view name;
  std::string unit;
};

Heading heading_of(std::string_view word) {
  auto const open = word.find_first_of("([");
  if (open != std::string_view::npos) {
    std::string_view unit = word.substr(open + 1);
    return {word.substr(0, open), std::string(unit.substr(0, unit.find_first_of(")]")))};
  }
  auto const line = word.find('_');
  if (line == std::string_view::npos) return {word, ""};
  std::string unit(word.substr(line + 1));
  std::replace(unit.begin(), unit.end(), '_', '/');
  return {word.substr(0, line), unit};
}

/// Whether more of the words are words than numbers.
bool is_words(TextLine const& line) {
  auto const words = words_of(line.text);
  auto const numbers = std::count_if(words.begin(), words.end(), [&](std::string_view word) {
    return number_of(word).has_value() || has_decimal_comma(word, line.text);
  });
  return 2 * static_cast<std::size_t>(numbers) < words.size();
}

/// A time, its text and the place of its line.
struct Instant {
  std::string_view word;
  double time;      // s
  double rounding;  // s, one of its last decimal
  std::size_t line;
};

/// What one of the last decimal of a number is: 0.01 of "3.25".
double last_decimal(std::string_view word) {
  auto const point = word.find('.');
  if (point == std::string_view::npos) return 1.0;
  if (word.find_first_of("eEdD") != std::string_view::npos) return 0.0;
  return std::pow(10.0, -static_cast<double>(word.size() - point - 1));
}

double median_step(std::vector<Instant> const& instants) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < instants.size(); ++i)
    steps.push_back(instants[i].time - instants[i - 1].time);
  auto const middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

void check_steps(std::vector<Instant> const& instants, double usual, RecordMistakes& mistakes) {
  for (std::size_t i = 1; i < instants.size(); ++i) {
    Instant const& now = instants[i];
    double const step = now.time - instants[i - 1].time;
    double const slack = 0.01 * usual + 1.01 * std::min(now.rounding, 0.5 * usual);
    std::string const at = fmt::format("time {}", now.word);
    if (step <= 0.0)
      mistakes.add_one_of_many(now.line, at, "does not come after the time before it",
                               "times that do not increase");
    else if (step > 1.5 * usual)
      mistakes.add_one_of_many(
          now.line, at,
          fmt::format("follows a gap of {:.6g} s; the usual step is {:.6g} s", step, usual),
          "gaps");
    else if (std::fabs(step - usual) > slack)
      mistakes.add_one_of_many(
          now.line, at,
          fmt::format("comes {:.6g} s after the one before it, not {:.6g} s", step, usual),
          "uneven steps");
  }
}

void refuse_commas(TextLine const& line, RecordMistakes& mistakes) {
  mistakes.add_one_of_many(line.number, quoted_word(line.text),
                           "has commas inside of numbers: decimals follow a point",
                           "lines with decimal commas");
}

class ColumnReader {
 public:
  ColumnReader(bool step_told, RecordMistakes& mistakes)
      : step_told_(step_told), mistakes_(mistakes) {}

  void add_heading(TextLine const& line) {
    auto const words = words_of(line.text);
    if (words.size() == 1) record_.unit = unit_of(words[0]);
    if (words.size() < 2) return;
    headings_ = words.size();
    heading_line_ = line.number;
    record_.unit = unit_of(words[1]);
    Heading const time = heading_of(words[0]);
    if (is_another_quantity(words[1])) {
      record_.another_quantity = true;
      mistakes_.add(line.number, quoted_word(words[1]), "is no acceleration",
                    "give the accelerations of the record, in a unit like g or m/s^2");
    }
    if (time.unit.empty() || record_.unit.empty()) return;
    if (auto const factor = to_si("1 " + time.unit, Quantity::time); factor.value)
      time_unit_ = *factor.value;
    else
      mistakes_.add(line.number, fmt::format("\"{}\"", words[0]), "has no unit of time");
  }

  void add_line(TextLine const& line) {
    ++lines_of_[words_of(line.text).size()];
    lines_.push_back(line);
  }

  FiledRecord record() {
    bool const two = lines_.size() > 1 && 2 * lines_of_[2] > lines_.size();
    if (two && (!step_told_ || headings_ == 2 || times_increase()))
      read_two_columns();
    else if (two && all_have_decimal_commas())
      for (TextLine const& line : lines_) refuse_commas(line, mistakes_);
    else if (headings_ > 2 && 2 * lines_of_[headings_] > lines_.size())
      mistakes_.add(heading_line_, fmt::format("a table of {} columns", headings_), "is no record",
                    "leave the time and one acceleration in it");
    else
      for (TextLine const& line : lines_) add_numbers(line, record_.values, mistakes_);
    return std::move(record_);
  }

 private:
  static std::string unit_of(std::string_view word) {
    Heading const heading = heading_of(word);
    return acceleration_unit(heading.unit) ? heading.unit : std::string();
  }

  /// Whether a heading bears a unit of velocity or displacement.
  static bool is_another_quantity(std::string_view word) {
    Heading const heading = heading_of(word);
    if (heading.unit.empty() || number_of(heading.name) || acceleration_unit(heading.unit))
      return false;
    auto const is = [&](Quantity quantity) {
      return to_si("1 " + heading.unit, quantity).value.has_value();
    };
    return is(Quantity::velocity) || is(Quantity::length);
  }

  bool times_increase() const {
    double before = -std::numeric_limits<double>::infinity();
    for (TextLine const& line : lines_) {
      double const time = number_of(words_of(line.text)[0]).value_or(before);
      if (time <= before) return false;
      before = time;
    }
    return true;
  }

  /// Whether the lines look like "0,35", numbers with decimal commas, all of them.
  bool all_have_decimal_commas() const {
    auto const digits = [](std::string_view text) {
      return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    };
    return std::all_of(lines_.begin(), lines_.end(), [&](TextLine const& line) {
      auto const comma = line.text.find(',');
      if (comma == std::string_view::npos) return false;
      std::string_view whole = line.text.substr(0, comma);
      whole.remove_prefix(std::min(whole.find_first_not_of("+-"), whole.size()));
      return digits(whole) && digits(line.text.substr(comma + 1));
    });
  }

  void read_two_columns() {
    std::vector<Instant> instants;
    for (TextLine const& line : lines_) {
      auto const words = words_of(line.text);
      if (words.size() != 2) {
        mistakes_.add_one_of_many(line.number, quoted_word(line.text),
                                  "is not a time and an acceleration", "lines of another length");
        continue;
      }
      std::vector<double> row;
      add_numbers(line, row, mistakes_);
      if (number_of(words[0]))
        instants.push_back(
            {words[0], row[0] * time_unit_, last_decimal(words[0]) * time_unit_, line.number});
      record_.values.push_back(row[1]);
    }
    if (instants.size() < 2 || instants.size() != lines_.size()) return;
    check_steps(instants, median_step(instants), mistakes_);
    record_.start = instants.front().time;
    record_.time_step =
        (instants.back().time - instants.front().time) / static_cast<double>(instants.size() - 1);
  }

  bool step_told_;
  RecordMistakes& mistakes_;
  FiledRecord record_;
  double time_unit_ = 1.0;  // s
  std::size_t headings_ = 0, heading_line_ = 0;
  std::vector<TextLine> lines_;
  std::map<std::size_t, std::size_t> lines_of_;  // lines with that many words
};

}  // namespace

void add_numbers(TextLine const& line, std::vector<double>& values, RecordMistakes& mistakes) {
  for (auto const word : words_of(line.text)) {
    auto const number = number_of(word);
    if (!number)
      mistakes.add_one_of_many(line.number, quoted_word(word),
                               has_decimal_comma(word, line.text)
                                   ? "is not a finite number: decimals follow a point, not a comma"
                                   : "is not a finite number",
                               "words that are no numbers");
    else if (has_decimal_comma(word, line.text))
      refuse_commas(line, mistakes);
    values.push_back(number.value_or(0.0));
  }
}

FiledRecord read_columns(std::vector<TextLine> const& lines, bool step_told,
                         RecordMistakes& mistakes) {
  ColumnReader reader(step_told, mistakes);
  bool heading = true;
  for (TextLine const& line : lines) {
    if (is_comment(line)) continue;
    if (heading && is_words(line)) {
      reader.add_heading(line);
      continue;
    }
    heading = false;
    reader.add_line(line);
  }
  return reader.record();
}

}  // namespace moraine
