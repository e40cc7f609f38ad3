// References of a case and the columns of readings that they belong to.
#pragma once

#include <filesystem>
#include <string>

#include "output/table_csv.hpp"
#include "setup/case.hpp"

namespace moraine {

/// The column of gauges.csv that a reference belongs to: name and unit. An empty name where the
/// gauge has no such column. The gauge is known to be there.
TableColumn column_of(Case const& c, ReferenceSpec const& reference);

/// A curve: times [s] and values (SI), from the first two columns of a CSV file with one line of
/// names. Throws std::runtime_error for a file that has not two columns of numbers in order of
/// time.
struct ReferenceCurve {
  std::vector<double> time, value;
};
ReferenceCurve read_reference_curve(std::filesystem::path const& file);

/// Throws InputErrors with all references whose gauges have no such column, whose measure is none
/// of their column, or whose files are no curves.
void check_references(Case const& c);

}  // namespace moraine
