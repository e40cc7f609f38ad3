#include "output/references.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "base/input_error.hpp"
#include "output/gauge_reader.hpp"

namespace moraine {
namespace {

std::vector<TableColumn> columns_of(Case const& c, std::string const& gauge_name) {
  for (GaugeSpec const& gauge : c.gauges)
    if (gauge.name == gauge_name) return make_gauge_reader(c, gauge).columns;
  return {};
}

bool is_of_pressures(ReadingMeasure measure) {
  return measure == ReadingMeasure::arrival || measure == ReadingMeasure::duration ||
         measure == ReadingMeasure::impulse;
}

/// Names of columns without that of their gauge: "pressure", and "[3] pressure" of a line.
std::vector<std::string> short_names(std::vector<TableColumn> const& columns,
                                     std::string const& gauge) {
  std::vector<std::string> names;
  for (TableColumn const& column : columns) {
    std::string name = column.name;
    if (name.starts_with(gauge)) name.erase(0, gauge.size());
    if (name.starts_with(' ')) name.erase(0, 1);
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

TableColumn column_of(Case const& c, ReferenceSpec const& reference) {
  auto const columns = columns_of(c, reference.gauge);
  if (columns.empty()) return {};
  if (reference.column.empty()) return columns.front();
  auto const names = short_names(columns, reference.gauge);
  auto const found = std::find(names.begin(), names.end(), reference.column);
  return found == names.end() ? TableColumn{}
                              : columns[static_cast<std::size_t>(found - names.begin())];
}

ReferenceCurve read_reference_curve(std::filesystem::path const& file) {
  Table const table = read_table_csv(file);
  if (table.columns.size() < 2) throw std::runtime_error("has less than two columns");
  if (table.rows() == 0) throw std::runtime_error("has no line of numbers");
  if (!std::is_sorted(table.values[0].begin(), table.values[0].end()))
    throw std::runtime_error("has times that are not in ascending order");
  return {table.values[0], table.values[1]};
}

void check_references(Case const& c) {
  std::vector<InputProblem> problems;
  for (ReferenceSpec const& reference : c.references) {
    std::string const key = "reference." + reference.name;
    TableColumn const column = column_of(c, reference);
    if (column.name.empty()) {
      auto const names = short_names(columns_of(c, reference.gauge), reference.gauge);
      std::vector<std::string_view> const known(names.begin(), names.end());
      problems.push_back(problem_of(c, key + ".column",
                                    fmt::format("is no column of gauge \"{}\"", reference.gauge),
                                    name_hint(reference.column, known)));
    } else if (is_of_pressures(reference.measure) && column.unit != "Pa") {
      problems.push_back(problem_of(c, key + ".measure",
                                    fmt::format("is told of pressures; {} is in {}", column.name,
                                                column.unit.empty() ? "no unit" : column.unit)));
    }
    if (reference.file.empty()) continue;
    try {
      read_reference_curve(reference.file);
    } catch (std::runtime_error const& error) {
      problems.push_back(problem_of(c, key + ".file", error.what()));
    }
  }
  if (!problems.empty()) throw InputErrors(std::move(problems));
}

}  // namespace moraine
