#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "output/plot/drawable.hpp"
#include "output/plot/plot.hpp"
#include "output/plot/stacked_panels.hpp"
#include "output/table_csv.hpp"

namespace moraine {
namespace {

using plot::Curve;
using plot::CurvePanel;

Table read_series(std::filesystem::path const& csv) {
  Table table = plot::read_drawable_table(csv);
  if (table.rows() == 0)
    throw std::runtime_error(fmt::format("table '{}' has no rows to plot", csv.string()));
  return table;
}

/// The panel of a quantity, made where it is not there yet.
CurvePanel& panel_of(std::vector<CurvePanel>& panels, std::string const& quantity,
                     std::string const& unit) {
  for (CurvePanel& panel : panels)
    if (panel.quantity == quantity && panel.unit == unit) return panel;
  return panels.emplace_back(CurvePanel{quantity, unit, {}});
}

std::vector<double> const& column(Table const& table, std::string const& name,
                                  std::filesystem::path const& csv) {
  if (std::vector<double> const* const values = table.find(name)) return *values;
  throw std::runtime_error(fmt::format("table '{}' has no column '{}'", csv.string(), name));
}

std::vector<double> change_since_start(std::vector<double> values) {
  double const start = values.front();
  for (double& value : values) value -= start;
  return values;
}

double largest_size(std::vector<double> const& values) {
  double largest = 0.0;
  for (double const value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

void plot_histories(std::filesystem::path const& csv, std::filesystem::path const& out) {
  Table const table = read_series(csv);
  std::vector<CurvePanel> panels;
  for (std::size_t i = 1; i < table.columns.size(); ++i) {
    std::string const& name = table.columns[i].name;
    std::size_t const space = name.rfind(' ');
    std::string const gauge = space == std::string::npos ? name : name.substr(0, space);
    std::string const quantity = space == std::string::npos ? name : name.substr(space + 1);
    panel_of(panels, quantity, table.columns[i].unit).curves.push_back({gauge, table.values[i]});
  }
  if (panels.empty())
    throw std::runtime_error(fmt::format("table '{}' has no gauges", csv.string()));
  plot::draw_stacked_panels(out, "Gauges", {"time", table.values[0]}, table.columns[0].unit,
                            panels);
}

void plot_sums(std::filesystem::path const& csv, std::filesystem::path const& out) {
  Table const table = read_series(csv);
  CurvePanel energies{"energy change", "J", {}};
  double exchanged = 0.0;
  for (char const* name : {"kinetic", "internal", "potential"}) {
    auto change = change_since_start(column(table, fmt::format("{}_energy", name), csv));
    exchanged = std::max(exchanged, largest_size(change));
    energies.curves.push_back({name, std::move(change)});
  }
  std::vector<double> total = change_since_start(column(table, "total_energy", csv));
  energies.curves.push_back({"total", total});

  for (double& value : total) value *= exchanged > 0.0 ? 100.0 / exchanged : 0.0;
  CurvePanel const error{"energy error", "%", {{"total", std::move(total)}}};

  CurvePanel momentum{"momentum", "kg m/s", {}};
  for (char const* axis : {"x", "y", "z"}) {
    std::vector<double> const& values = column(table, fmt::format("momentum_{}", axis), csv);
    if (largest_size(values) > 0.0)
      momentum.curves.push_back({fmt::format("momentum {}", axis), values});
  }
  CurvePanel const step{"time step", "s", {{"", column(table, "time_step", csv)}}};

  std::vector<CurvePanel> panels{std::move(energies), error};
  if (!momentum.curves.empty()) panels.push_back(std::move(momentum));
  panels.push_back(step);
  plot::draw_stacked_panels(out, "Conserved sums and time step",
                            {"time", column(table, "time", csv)}, "s", panels);
}

}  // namespace moraine
