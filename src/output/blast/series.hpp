// Answers along a range of distances, angles, times, depths or charges.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "blast/estimate.hpp"
#include "output/blast/output_units.hpp"

namespace moraine::blast {

/// Answers at values of one input.
struct Series {
  std::string variable;        // "distance"
  std::string unit;            // in which it is shown
  bool logarithmic = false;    // how it is spread and drawn
  std::vector<double> points;  // shown
  std::vector<Answer> answers;
};

/// What a number in a table is worth; also the numbers of the status columns.
enum class Status { in_range = 0, range_not_stated = 1, outside_range = 2, doubtful = 3 };
Status status_of(Estimate const& estimate);

/// One relation along a series; NaN where it has no value.
struct Column {
  Relation const* relation;
  std::vector<double> values;  // shown
  std::vector<Status> status;
};
std::vector<Column> columns_of(Series const& series, OutputUnits const& units);

/// Tables for people, one per measure; numbers that need care are marked.
std::string series_text(Series const& series, OutputUnits const& units);

/// A CSV file: the variable, then for each relation `<measure> <relation> [unit]` and `<measure>
/// <relation> status` (a Status). Throws OutputError.
void write_csv(std::filesystem::path const& path, Series const& series, OutputUnits const& units);

/// A picture (SVG or PNG by the ending): a panel per measure, a curve per relation, thin and dashed
/// where it is outside its range or doubtful. Measures that stay the same are left out. Throws
/// std::invalid_argument for another ending.
void draw_series(std::filesystem::path const& path, std::string const& title, Series const& series,
                 OutputUnits const& units);

}  // namespace moraine::blast
