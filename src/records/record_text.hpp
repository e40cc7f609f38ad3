// The text of a record: lines, numbers, and the mistakes found in them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_error.hpp"

namespace moraine {

struct TextLine {
  std::size_t number = 0;  // from 1
  std::string_view text;   // without blanks at its ends
};

/// Lines with something in them. A byte-order mark in front is left out.
std::vector<TextLine> lines_of(std::string_view text);

/// Whether a line is a comment.
bool is_comment(TextLine const& line);

/// Whether a text holds no control characters but blanks and ends of lines, so that it is safe to
/// show. UTF-16 is no text here.
bool is_text(std::string_view text);

/// Words of a line: between semicolons, tabs or commas, the first of them that it has, else between
/// blanks; "(unit)" and "[unit]" stay with the word before them.
std::vector<std::string_view> words_of(std::string_view line);

/// A word in quotes for a message, cut after 60 bytes.
std::string quoted_word(std::string_view word);

/// A finite number, as C or Fortran writes it ("1.5e-3", "1.5D-03", "+.5").
std::optional<double> number_of(std::string_view word);

/// Whether a word is a number but for a decimal comma ("0,35"), or is what follows one in a line
/// that was split at its commas ("05", "05 1").
bool has_decimal_comma(std::string_view word, std::string_view line);

/// Mistakes in a record, at most ten of a kind one by one.
class RecordMistakes {
 public:
  explicit RecordMistakes(std::string file) : file_(std::move(file)) {}

  /// A mistake of the whole file, or at a line.
  void add(std::size_t line, std::string value, std::string rule, std::string hint = {});

  /// A mistake of which there may be many; `kind` names them in the summary.
  void add_one_of_many(std::size_t line, std::string value, std::string rule, std::string kind);

  bool empty() const { return problems_.empty(); }

  /// Throws InputErrors if there are mistakes.
  void raise() const;

 private:
  struct Kind {
    std::string name;
    std::size_t count = 0;
    std::size_t last_line = 0;
  };

  std::string file_;
  std::vector<InputProblem> problems_;
  std::vector<Kind> kinds_;
};

}  // namespace moraine
