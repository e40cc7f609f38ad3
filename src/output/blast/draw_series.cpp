#include <algorithm>
#include <cmath>

#include "output/blast/series.hpp"
#include "output/plot/stacked_panels.hpp"

namespace moraine::blast {
namespace {

/// The parts of a column with a status that is to be trusted, or the others. A part of the others
/// begins and ends at a trusted point, so that the two kinds of curve meet.
plot::Curve part(Column const& column, bool trusted) {
  auto const is_trusted = [&](std::size_t i) {
    return column.status[i] == Status::in_range || column.status[i] == Status::range_not_stated;
  };
  std::size_t const rows = column.values.size();
  bool const doubtful = column.relation->standing == Standing::doubtful;
  plot::Curve curve{doubtful ? "doubtful" : std::string(column.relation->name), column.values,
                    !trusted};
  for (std::size_t i = 0; i < rows; ++i) {
    bool const meets = (i > 0 && !is_trusted(i - 1)) || (i + 1 < rows && !is_trusted(i + 1));
    bool const kept = trusted ? is_trusted(i) : !is_trusted(i) || meets;
    if (!kept) curve.values[i] = unknown;
  }
  return curve;
}

/// Whether a relation says the same everywhere.
bool constant(Column const& column) {
  return std::ranges::all_of(column.values,
                             [&](double value) { return value == column.values.front(); });
}

/// The columns of measures that change along the series.
std::vector<Column> changing(std::vector<Column> columns) {
  auto const changes = [&](Measure measure) {
    return std::ranges::any_of(columns, [&](Column const& column) {
      return column.relation->measure == measure && !constant(column);
    });
  };
  std::vector<Column> kept;
  for (Column const& column : columns)
    if (changes(column.relation->measure)) kept.push_back(column);
  return kept.empty() ? columns : kept;
}

}  // namespace

void draw_series(std::filesystem::path const& path, std::string const& title, Series const& series,
                 OutputUnits const& units) {
  plot::Scale const scale = series.logarithmic ? plot::Scale::logarithmic : plot::Scale::linear;
  std::vector<plot::CurvePanel> panels;
  for (Column const& column : changing(columns_of(series, units))) {
    std::string const name = words(info(column.relation->measure).name);
    std::string const unit = units.unit(column.relation->measure);
    if (panels.empty() || panels.back().quantity != name)
      panels.push_back({name, unit == "1" ? "" : unit, {}, scale});
    panels.back().curves.push_back(part(column, true));
    panels.back().curves.push_back(part(column, false));
  }
  // Relations that agree hide each other: the first one of a panel shows below the others.
  for (plot::CurvePanel& panel : panels) panel.curves.front().broad = panel.curves.size() > 2;
  plot::draw_stacked_panels(path, plot::heading(title), {series.variable, series.points},
                            series.unit, panels, scale);
}

}  // namespace moraine::blast
