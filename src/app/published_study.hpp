// Numbers that a study printed, and where a run of ours has the same.
#pragma once

#include <span>
#include <string_view>

namespace moraine {

/// What is taken of a column of gauges.csv.
enum class Taken { at_time, largest, time_of_largest };

struct PublishedNumber {
  std::string_view case_name;  // of the shipped cases
  std::string_view what;       // "crater diameter"
  std::string_view column;     // "crater apparent_diameter"
  Taken taken;
  double time;   // s, of at_time
  double value;  // as printed, SI
  std::string_view unit;
  std::string_view note;  // what the study leaves open; may be empty
};

struct PublishedStudy {
  std::string_view name;
  std::string_view source;
  std::span<PublishedNumber const> numbers;
  /// Why numbers disagree, with the evidence; paragraphs.
  std::string_view reasons;
};

std::span<PublishedStudy const> published_studies();

}  // namespace moraine
