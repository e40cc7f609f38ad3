// The kinds of text that a record can come in.
#pragma once

#include <vector>

#include "records/record_reader.hpp"
#include "records/record_text.hpp"

namespace moraine {

/// A record as its file gives it, in the file's unit.
struct FiledRecord {
  double start = 0.0;      // s
  double time_step = 0.0;  // s; 0 where the file does not say
  std::vector<double> values;
  std::string unit;               // as written; empty where the file does not say
  bool another_quantity = false;  // velocities or displacements, which is a mistake
};

/// The line of an AT2 file that holds NPTS and DT, counted in `lines`; nothing for other texts.
std::optional<std::size_t> at2_header_end(std::vector<TextLine> const& lines);

/// A file of PEER. What is wrong goes to `mistakes`.
FiledRecord read_at2(std::vector<TextLine> const& lines, std::size_t header_end,
                     RecordMistakes& mistakes);

/// Two columns or plain numbers; `step_told`: the user gives a time step, so that two columns
/// without names are times only where they increase. What is wrong goes to `mistakes`.
FiledRecord read_columns(std::vector<TextLine> const& lines, bool step_told,
                         RecordMistakes& mistakes);

/// Adds all words of a line to `values`; what is no number counts as a mistake and as a value, so
/// that counts stay right.
void add_numbers(TextLine const& line, std::vector<double>& values, RecordMistakes& mistakes);

}  // namespace moraine
