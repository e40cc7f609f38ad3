// What a case says that its readings should be: measurements and exact values of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace moraine {

/// Which number of a column of readings is compared (probes/reading_summary.hpp).
enum class ReadingMeasure : std::uint8_t {
  largest,
  smallest,
  time_of_largest,
  time_of_smallest,
  arrival,
  duration,
  impulse,
  integral,
  last
};

/// Beside a column of a gauge: a curve from a file, or a value. Reports show both; runs do not
/// depend on them.
struct ReferenceSpec {
  std::string name;
  std::string gauge;
  std::string column;  // "pressure"; empty: the first of the gauge
  std::string file;    // of the case: relative to it; after reading: absolute; empty: a value
  ReadingMeasure measure = ReadingMeasure::largest;
  std::optional<double> value;      // in the SI unit of the measure
  std::optional<double> tolerance;  // share of |value|
  std::optional<double> within;     // the same in the unit of the value; neither: not judged
  std::string source;
};

}  // namespace moraine
