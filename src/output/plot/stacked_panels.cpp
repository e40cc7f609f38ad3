#include "output/plot/stacked_panels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/plot/color_map.hpp"
#include "output/plot/curve.hpp"
#include "output/si_prefix.hpp"

namespace moraine::plot {
namespace {

constexpr double panel_width = 400.0, panel_height = 128.0;  // pt, of the plotting area
constexpr double least_left_margin = 56.0, right_margin = 16.0, bottom_margin = 38.0;
constexpr double panel_gap = 14.0, legend_row = 14.0, title_height = 26.0;

struct Extremes {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(std::vector<double> const& values, Scale scale) {
    for (double const value : values) {
      if (!std::isfinite(value) || (scale == Scale::logarithmic && value <= 0.0)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  void close() {
    if (!(low <= high)) low = high = 0.0;
  }
  double size() const { return std::max(std::abs(low), std::abs(high)); }
};

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value /= factor;
  return values;
}

/// Names of all curves in the order they come, one entry per name.
std::vector<std::string> legend_names(std::vector<CurvePanel> const& panels) {
  std::vector<std::string> names;
  for (CurvePanel const& panel : panels)
    for (Curve const& curve : panel.curves)
      if (!curve.name.empty() && std::find(names.begin(), names.end(), curve.name) == names.end())
        names.push_back(curve.name);
  return names;
}

/// Style of the curve with this place in the legend; curves without a name follow behind it.
CurveStyle style_of(std::size_t index) {
  return {.color = line_color(index), .width = 1.2, .dashed = index % 14 >= 7};
}

struct LegendEntry {
  double x;
  double row;
};

/// Places of the legend's entries, from left to right in as many rows as needed.
std::vector<LegendEntry> arrange_legend(std::vector<std::string> const& names, double width) {
  std::vector<LegendEntry> entries;
  double x = 0.0, row = 0.0;
  for (std::string const& name : names) {
    double const needed = 22.0 + text_width(name, tick_style) + 16.0;
    if (x > 0.0 && x + needed - 16.0 > width) {
      x = 0.0;
      row += 1.0;
    }
    entries.push_back({x, row});
    x += needed;
  }
  return entries;
}

void draw_legend(Canvas& canvas, std::vector<std::string> const& names,
                 std::vector<LegendEntry> const& entries, double left, double top) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    double const x = left + entries[i].x;
    double const y = top + (entries[i].row + 0.5) * legend_row;
    CurveStyle const style = style_of(i);
    double const dashes[] = {4.0, 2.0};
    if (style.dashed) cairo_set_dash(canvas.cairo(), dashes, 2, 0.0);
    canvas.line(x, y, x + 17.0, y, style.color, 1.8);
    cairo_set_dash(canvas.cairo(), dashes, 0, 0.0);
    canvas.text(x + 22.0, y, names[i], tick_style);
  }
}

/// Rows and columns of panels on the page.
struct Grid {
  Grid(std::size_t panels, std::size_t wanted_columns, double margin)
      : left_margin(margin),
        columns(wanted_columns > 0 ? wanted_columns
                : panels > 4       ? 2
                                   : 1),
        rows((panels + columns - 1) / columns),
        count(panels) {}

  double width() const {
    return static_cast<double>(columns) * (left_margin + panel_width + right_margin);
  }
  Rect area(std::size_t index, double top) const {
    return {left_margin +
                static_cast<double>(index % columns) * (left_margin + panel_width + right_margin),
            top + static_cast<double>(index / columns) * (panel_height + panel_gap), panel_width,
            panel_height};
  }
  bool lowest(std::size_t index) const { return index + columns >= count; }

  double left_margin;
  std::size_t columns, rows, count;
};

/// An axis and the factor between its numbers and those of the curves.
struct ScaledAxis {
  Axis axis;
  double factor;
};

ScaledAxis scaled_axis(Extremes const& range, Scale scale, double margin, std::string_view name,
                       std::string_view unit) {
  if (scale == Scale::logarithmic)
    return {log_axis_around(range.low, range.high, margin, axis_label(name, typeset_unit(unit))),
            1.0};
  DisplayUnit const shown = display_unit(unit, range.size());
  return {axis_around(range.low / shown.factor, range.high / shown.factor, margin,
                      axis_label(name, shown.unit)),
          shown.factor};
}

ScaledAxis value_axis(CurvePanel const& data) {
  Extremes range;
  auto const faint = [](Curve const& curve) { return curve.faint; };
  bool const all = std::ranges::all_of(data.curves, faint);
  for (Curve const& curve : data.curves)
    if (all || !curve.faint) range.include(curve.values, data.scale);
  range.include(data.shown_values, data.scale);
  range.close();
  return scaled_axis(range, data.scale, 0.06, data.quantity, data.unit);
}

double left_margin_for(std::vector<CurvePanel> const& panels) {
  double margin = least_left_margin;
  for (CurvePanel const& data : panels) {
    Panel const panel({0.0, 0.0, panel_width, panel_height}, {}, value_axis(data).axis);
    margin = std::max(margin, panel.y_label_room());
  }
  return margin;
}

/// What all panels of a page share.
struct Page {
  std::vector<std::string> names;  // in the legend
  std::vector<double> x;           // displayed units
  Axis x_axis;
  Grid grid;
};

void draw_panel(Canvas& canvas, Page const& page, CurvePanel const& data, Rect const& area,
                bool lowest) {
  ScaledAxis const value = value_axis(data);
  Panel const panel(area, page.x_axis, value.axis);
  panel.draw_grid(canvas);
  for (Curve const& curve : data.curves) {
    auto const place =
        std::find(page.names.begin(), page.names.end(), curve.name) - page.names.begin();
    CurveStyle style = style_of(static_cast<std::size_t>(place));
    if (curve.broad) style.width *= 2.5;
    if (curve.faint) style = {.color = style.color, .width = 0.6, .dashed = true};
    draw_curve(canvas, panel, page.x, scaled(curve.values, value.factor), style);
  }
  panel.draw_axes(canvas, {.x_labels = lowest, .y_labels = true}, page.grid.left_margin);
}

}  // namespace

void draw_stacked_panels(std::filesystem::path const& out, std::string const& title, Curve const& x,
                         std::string const& x_unit, std::vector<CurvePanel> const& panels,
                         Scale x_scale, std::size_t columns) {
  Extremes range;
  range.include(x.values, x_scale);
  range.close();
  auto const [x_axis, factor] = scaled_axis(range, x_scale, 0.0, x.name, x_unit);
  Page const page{legend_names(panels), scaled(x.values, factor),
                  x_scale == Scale::linear ? rounded_out(x_axis) : x_axis,
                  Grid(panels.size(), columns, left_margin_for(panels))};
  Grid const& grid = page.grid;

  double const legend_width = grid.width() - grid.left_margin - right_margin;
  std::vector<LegendEntry> const legend = arrange_legend(page.names, legend_width);
  double const legend_height = (legend.empty() ? 0.0 : legend.back().row + 1.0) * legend_row;
  double const top = title_height + legend_height + 6.0;
  auto const rows = static_cast<double>(grid.rows);
  Canvas canvas(out, grid.width(),
                top + rows * panel_height + (rows - 1.0) * panel_gap + bottom_margin);
  TextStyle title_style = label_style;
  title_style.bold = true;
  canvas.text(grid.left_margin, 15.0, title, title_style);
  draw_legend(canvas, page.names, legend, grid.left_margin, title_height);
  for (std::size_t i = 0; i < panels.size(); ++i)
    draw_panel(canvas, page, panels[i], grid.area(i, top), grid.lowest(i));
  canvas.finish();
}

}  // namespace moraine::plot
