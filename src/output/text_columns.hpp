// Tables as plain text.
#pragma once

#include <string>
#include <vector>

namespace moraine {

/// Rows of cells in columns of equal width: the first columns, which have names from the start, to
/// the left, added ones to the right. Letters of UTF-8 count as one.
class TextColumns {
 public:
  explicit TextColumns(std::vector<std::string> left) : headings_(std::move(left)) {
    left_ = headings_.size();
  }

  void add_column(std::string heading) { headings_.push_back(std::move(heading)); }
  /// Missing cells stay empty.
  void add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  /// Headings and rows, each line with its end.
  std::string text() const;

 private:
  std::size_t left_ = 0;
  std::vector<std::string> headings_;
  std::vector<std::vector<std::string>> rows_;
};

/// A cell of CSV: quoted as in RFC 4180, section 2, where it must be.
std::string quoted_cell(std::string const& text);

}  // namespace moraine
