#include "output/plot/color_bar.hpp"

#include <algorithm>
#include <cmath>

#include "output/plot/color_map.hpp"

namespace moraine::plot {
namespace {

constexpr double tick_length = 3.0;    // pt
constexpr double tick_gap = 6.0;       // pt, from the bar to the numbers
constexpr double label_offset = 12.0;  // pt, from the numbers to the middle of the label
constexpr int gradient_stops = 64;

double quantile(std::vector<double>& values, double part) {
  auto const at =
      values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Fills the bar; in its own coordinates it lies along x, length by thickness, from the origin.
void draw_gradient(Canvas& canvas, double length, double thickness, ColorRange const& range) {
  cairo_t* const context = canvas.cairo();
  cairo_pattern_t* const gradient = cairo_pattern_create_linear(0.0, 0.0, length, 0.0);
  for (int i = 0; i <= gradient_stops; ++i) {
    double const t = static_cast<double>(i) / gradient_stops;
    Color const color = viridis(t);
    cairo_pattern_add_color_stop_rgb(gradient, t, color.red, color.green, color.blue);
  }
  cairo_move_to(context, 0.0, 0.0);
  cairo_line_to(context, length, 0.0);
  if (range.above) cairo_line_to(context, length + thickness, 0.5 * thickness);
  cairo_line_to(context, length, thickness);
  cairo_line_to(context, 0.0, thickness);
  if (range.below) cairo_line_to(context, -thickness, 0.5 * thickness);
  cairo_close_path(context);
  cairo_set_source(context, gradient);
  cairo_fill_preserve(context);
  cairo_pattern_destroy(gradient);
  canvas.set_color(ink);
  cairo_set_line_width(context, 0.7);
  cairo_stroke(context);
}

Ticks upright_ticks(Axis const& scale, double height) {
  return round_ticks(scale.low, scale.high, static_cast<int>(height / 30.0));
}

}  // namespace

ColorRange color_range(std::vector<double> const& values) {
  std::vector<double> finite;
  for (double const value : values)
    if (std::isfinite(value)) finite.push_back(value);
  if (finite.empty()) return {};
  auto const [low, high] = std::minmax_element(finite.begin(), finite.end());
  ColorRange range{*low, *high, false, false};
  double const cut_low = quantile(finite, 0.001), cut_high = quantile(finite, 0.999);
  if (cut_high > cut_low && 3.0 * (cut_high - cut_low) < range.high - range.low)
    range = {cut_low, cut_high, range.low<cut_low, range.high> cut_high};
  // Rounding noise of a uniform field is not worth colours.
  double const size = std::max(std::abs(range.low), std::abs(range.high));
  if (range.high - range.low <= 1e-6 * size || size == 0.0) {
    double const half = size > 0.0 ? 0.01 * size : 1.0;
    range = {range.low - half, range.high + half, false, false};
  }
  return range;
}

ColorRange common_range(std::vector<ColorRange> const& ranges) {
  std::vector<double> low, high;
  for (ColorRange const& range : ranges) {
    low.push_back(range.low);
    high.push_back(range.high);
  }
  std::sort(low.begin(), low.end());
  std::sort(high.begin(), high.end());
  return {low[(low.size() - 1) / 2], high[high.size() / 2], false, false};
}

double upright_bar_room(Axis const& scale, double height) {
  double widest = 0.0;
  for (std::string const& label : upright_ticks(scale, height).labels)
    widest = std::max(widest, text_width(label, tick_style));
  return tick_gap + widest + 2.0 * label_offset;
}

void draw_upright_bar(Canvas& canvas, Rect const& area, Axis const& scale,
                      ColorRange const& range) {
  cairo_t* const context = canvas.cairo();
  cairo_save(context);
  cairo_translate(context, area.left, area.bottom());
  cairo_rotate(context, -std::acos(0.0));
  draw_gradient(canvas, area.height, area.width, range);
  cairo_restore(context);

  Ticks const ticks = upright_ticks(scale, area.height);
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    double const part = (ticks.values[i] - scale.low) / (scale.high - scale.low);
    double const y = area.bottom() - part * area.height;
    canvas.line(area.right(), y, area.right() + tick_length, y, ink, 0.7);
    canvas.text(area.right() + tick_gap, y, ticks.labels[i], tick_style);
  }
  TextStyle style = label_style;
  style.align = Align::center;
  style.upward = true;
  double const room = upright_bar_room(scale, area.height);
  canvas.text(area.right() + room - label_offset, area.top + area.height / 2.0, scale.label, style);
}

void draw_lying_bar(Canvas& canvas, Rect const& area, Axis const& scale, ColorRange const& range) {
  cairo_t* const context = canvas.cairo();
  cairo_save(context);
  cairo_translate(context, area.left, area.top);
  draw_gradient(canvas, area.width, area.height, range);
  cairo_restore(context);

  TextStyle style = tick_style;
  style.align = Align::center;
  Ticks const ticks = round_ticks(scale.low, scale.high, static_cast<int>(area.width / 55.0));
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    double const part = (ticks.values[i] - scale.low) / (scale.high - scale.low);
    double const x = area.left + part * area.width;
    canvas.line(x, area.bottom(), x, area.bottom() + tick_length, ink, 0.7);
    canvas.text(x, area.bottom() + 10.0, ticks.labels[i], style);
  }
  style = label_style;
  style.align = Align::center;
  canvas.text(area.left + area.width / 2.0, area.bottom() + 24.0, scale.label, style);
}

}  // namespace moraine::plot
