#include "output/blast/series.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "output/table_csv.hpp"

namespace moraine::blast {
namespace {

constexpr std::size_t width = 14;  // of a column of text

std::string heading(Column const& column) {
  return fmt::format("{} {}", words(info(column.relation->measure).name), column.relation->name);
}

/// "123.4", with a mark where care is needed.
std::string cell(Column const& column, std::size_t row) {
  constexpr std::string_view marks[] = {"", "?", "!", "!!"};
  return readable(column.values[row]) +
         std::string(marks[static_cast<std::size_t>(column.status[row])]);
}

/// The table of one measure.
std::string block(Series const& series, std::vector<Column const*> const& columns,
                  OutputUnits const& units) {
  Measure const measure = columns.front()->relation->measure;
  std::string text = fmt::format("\n{}\n{:<{}}", with_unit(info(measure).name, units.unit(measure)),
                                 with_unit(series.variable, series.unit), width + 4);
  auto const room = [](Column const& c) { return std::max(width, c.relation->name.size() + 2); };
  for (Column const* column : columns)
    text += fmt::format("{:>{}}", column->relation->name, room(*column));
  text += '\n';
  for (std::size_t row = 0; row < series.points.size(); ++row) {
    text += fmt::format("{:<{}}", readable(series.points[row]), width + 4);
    for (Column const* column : columns)
      text += fmt::format("{:>{}}", cell(*column, row), room(*column));
    text += '\n';
  }
  return text;
}

}  // namespace

Status status_of(Estimate const& estimate) {
  if (estimate.standing == Standing::doubtful) return Status::doubtful;
  if (!estimate.in_range) return Status::outside_range;
  bool const unstated = estimate.relation->validity.known == Validity::Known::unstated;
  return unstated ? Status::range_not_stated : Status::in_range;
}

std::vector<Column> columns_of(Series const& series, OutputUnits const& units) {
  std::vector<Column> columns;
  std::size_t const rows = series.points.size();
  for (std::size_t row = 0; row < rows; ++row)
    for (Estimate const& estimate : series.answers[row].estimates) {
      auto column = std::ranges::find(columns, estimate.relation, &Column::relation);
      if (column == columns.end())
        column =
            columns.insert(columns.end(), {estimate.relation, std::vector<double>(rows, unknown),
                                           std::vector<Status>(rows, Status::outside_range)});
      column->values[row] = units.shown(estimate.relation->measure, estimate.value);
      column->status[row] = status_of(estimate);
    }
  std::ranges::stable_sort(columns, {}, [](Column const& c) { return c.relation->measure; });
  return columns;
}

std::string series_text(Series const& series, OutputUnits const& units) {
  auto const columns = columns_of(series, units);
  std::string text;
  std::vector<Column const*> group;
  auto const flush = [&] {
    if (!group.empty()) text += block(series, group, units);
    group.clear();
  };
  for (Column const& column : columns) {
    if (!group.empty() && group.front()->relation->measure != column.relation->measure) flush();
    group.push_back(&column);
  }
  flush();
  return text +
         "\n?  its source states no range   !  outside its range   !!  doubtful; one point alone "
         "or "
         "--json says more\n";
}

void write_csv(std::filesystem::path const& path, Series const& series, OutputUnits const& units) {
  auto const columns = columns_of(series, units);
  std::vector<TableColumn> headings{{series.variable, series.unit}};
  for (Column const& column : columns) {
    std::string const unit = units.unit(column.relation->measure);
    headings.push_back({heading(column), unit == "1" ? "" : unit});
    headings.push_back({heading(column) + " status", ""});
  }
  TableCsv table(path, headings);
  for (std::size_t row = 0; row < series.points.size(); ++row) {
    std::vector<double> numbers{series.points[row]};
    for (Column const& column : columns) {
      numbers.push_back(column.values[row]);
      numbers.push_back(static_cast<double>(column.status[row]));
    }
    table.add(numbers);
  }
}

}  // namespace moraine::blast
