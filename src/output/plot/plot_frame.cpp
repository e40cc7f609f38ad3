#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "output/plot/color_bar.hpp"
#include "output/plot/color_map.hpp"
#include "output/plot/dots.hpp"
#include "output/plot/drawable.hpp"
#include "output/plot/frame_field.hpp"
#include "output/plot/plot.hpp"
#include "output/si_prefix.hpp"

namespace moraine {
namespace {

using namespace plot;

constexpr Color wall_color{0.72, 0.72, 0.74};
constexpr int color_levels = 255;

// Discs of the square root of two spacings just cover a square lattice.
constexpr double overlap = 1.42;

/// Least width over height of a view: title and number of particles need the room above the plot.
constexpr double narrowest_view = 150.0 / 440.0;

/// The part of the domain that is shown [m], with the axes of the page.
struct View {
  std::size_t across = 0, up = 1;  // axes of the frame
  double left = std::numeric_limits<double>::infinity(), right = -left;
  double bottom = left, top = -left;

  void include(ParticleFrame const& frame) {
    for (std::size_t i = 0; i < frame.size; ++i) {
      double const x = frame.points.values[3 * i + across], y = frame.points.values[3 * i + up];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      bottom = std::min(bottom, y);
      top = std::max(top, y);
    }
  }
  void widen(double margin) {
    left -= margin;
    right += margin;
    bottom -= margin;
    top += margin;
  }
  void widen_to_narrowest() {
    double const lacking = narrowest_view * height() - width();
    if (!(lacking > 0.0)) return;
    left -= 0.5 * lacking;
    right += 0.5 * lacking;
  }
  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

/// Sizes of the page: the plot keeps the shape of the view; the colour bar stands to the right of
/// it, or lies below where the plot is wide and low.
struct Layout {
  static constexpr double left = 54.0, top = 28.0, axis_below = 36.0;
  static constexpr double widest = 400.0, highest = 440.0;

  explicit Layout(View const& view) {
    double const aspect = view.height() / view.width();
    lying_bar = aspect < 0.45;
    plot = {left, top, widest, widest * aspect};
    if (plot.height > highest) plot = {left, top, highest / aspect, highest};
    if (lying_bar) {
      bar = {left, plot.bottom() + axis_below + 10.0, plot.width, 10.0};
      page_width = plot.right() + 20.0;
      page_height = bar.bottom() + 34.0;
    } else {
      bar = {plot.right() + 14.0, plot.top, 11.0, plot.height};
      page_height = plot.bottom() + axis_below;
    }
  }

  /// Makes room for what the bar carries.
  void fit_bar(ColorRange const& range, Axis const& scale) {
    if (!lying_bar) page_width = bar.right() + upright_bar_room(scale, bar.height);
    double const below = range.below ? 11.0 : 0.0, above = range.above ? 11.0 : 0.0;
    if (lying_bar) {
      bar.left += below;
      bar.width -= below + above;
    } else {
      bar.top += above;
      bar.height -= below + above;
    }
  }

  bool lying_bar = false;
  Rect plot, bar;
  double page_width = 0.0, page_height = 0.0;
};

/// Steps of 5 %, so that dots of nearly the same size share a pen.
double rounded_size(double size) { return std::exp(std::round(std::log(size) / 0.05) * 0.05); }

/// Order of drawing: far before near in 3D, otherwise as they come.
std::vector<std::size_t> drawing_order(ParticleFrame const& frame) {
  std::vector<std::size_t> order(frame.size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (frame.dimension == 3)
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return frame.points.values[3 * a + 1] > frame.points.values[3 * b + 1];
    });
  return order;
}

class FramePicture {
 public:
  FramePicture(ParticleFrame const& frame, View const& view, Layout const& layout)
      : frame_(frame), view_(view), layout_(layout), sizes_(spacings(frame)) {
    typical_ = median_of_positive(sizes_);
  }

  /// Dots of all particles, coloured by `color(i)`. Particles without a size get `fallback` [m].
  template <class ColorOf>
  std::vector<Dot> dots(double fallback, ColorOf color) const {
    double const to_page = layout_.plot.width / view_.width();
    std::vector<Dot> result;
    result.reserve(frame_.size);
    for (std::size_t const i : drawing_order(frame_)) {
      double const x = frame_.points.values[3 * i + view_.across];
      double const y = frame_.points.values[3 * i + view_.up];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      double const spacing = size(i, fallback);
      result.push_back({layout_.plot.left + (x - view_.left) * to_page,
                        layout_.plot.bottom() - (y - view_.bottom) * to_page,
                        rounded_size(overlap * spacing * to_page), color(i)});
    }
    if (frame_.dimension == 2) group_by_pen(result);
    return result;
  }

 private:
  double size(std::size_t i, double fallback) const {
    if (!(sizes_[i] > 0.0)) return fallback;
    return std::clamp(sizes_[i], 0.25 * typical_, 4.0 * typical_);
  }

  static void group_by_pen(std::vector<Dot>& dots) {
    std::stable_sort(dots.begin(), dots.end(), [](Dot const& a, Dot const& b) {
      if (a.diameter != b.diameter) return a.diameter > b.diameter;
      if (a.color.green != b.color.green) return a.color.green < b.color.green;
      return a.color.red < b.color.red;
    });
  }

  ParticleFrame const& frame_;
  View const& view_;
  Layout const& layout_;
  std::vector<double> sizes_;
  double typical_ = 0.0;
};

ColorRange chosen_range(FramePlotOptions const& options, std::vector<double> const& values) {
  if (!options.range) return color_range(values);
  auto const [low, high] = *options.range;
  if (!(high > low)) throw std::invalid_argument("the colour range must go from low to high");
  auto const [smallest, largest] = std::minmax_element(values.begin(), values.end());
  return {low, high, !values.empty() && *smallest < low, !values.empty() && *largest > high};
}

std::string grouped_digits(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, " ");
  return text;
}

void draw_title(Canvas& canvas, Layout const& layout, ParticleFrame const& frame) {
  TextStyle style = label_style;
  style.bold = true;
  canvas.text(layout.plot.left, 16.0, "t = " + with_unit(frame.time, "s"), style);
  style = tick_style;
  style.align = Align::right;
  style.color = grey;
  canvas.text(layout.plot.right(), 16.0, grouped_digits(frame.size) + " particles", style);
}

Axis color_scale(FrameField const& field, ColorRange const& range) {
  DisplayUnit const unit =
      display_unit(field.unit, std::max(std::abs(range.low), std::abs(range.high)));
  return {range.low / unit.factor, range.high / unit.factor, axis_label(field.name, unit.unit)};
}

void draw_scales(Canvas& canvas, View const& view, Layout const& layout, Axis const& scale,
                 ColorRange const& range) {
  DisplayUnit const length = display_unit("m", std::max(view.width(), view.height()));
  auto const axis = [&](std::size_t direction, double low, double high) {
    return Axis{low / length.factor, high / length.factor,
                fmt::format("{} ({})", "xyz"[direction], length.unit)};
  };
  Panel const panel(layout.plot, axis(view.across, view.left, view.right),
                    axis(view.up, view.bottom, view.top));
  panel.draw_axes(canvas, {}, std::min(Layout::left, panel.y_label_room()));
  if (layout.lying_bar)
    draw_lying_bar(canvas, layout.bar, scale, range);
  else
    draw_upright_bar(canvas, layout.bar, scale, range);
}

View view_of(ParticleFrame const& frame, ParticleFrame const& walls, double spacing) {
  View view;
  view.up = frame.dimension == 3 ? 2 : 1;
  view.include(frame);
  view.include(walls);
  if (!(view.left <= view.right)) view.left = view.bottom = view.right = view.top = 0.0;
  double const extent = std::max(view.width(), view.height());
  // So wide that the view has a size where its places have few digits left.
  double const farthest = std::max(
      {std::abs(view.left), std::abs(view.right), std::abs(view.bottom), std::abs(view.top)});
  view.widen(std::max(0.5 * spacing + (extent > 0.0 ? 0.01 * extent : 0.5), 1e-9 * farthest));
  view.widen_to_narrowest();
  return view;
}

}  // namespace

void plot_frame(std::filesystem::path const& vtp, std::string const& field,
                std::filesystem::path const& out, FramePlotOptions const& options) {
  ParticleFrame const frame = read_drawable_frame(vtp);
  if (frame.dimension == 1)
    throw std::invalid_argument(
        fmt::format("'{}' is one-dimensional: plot a profile instead", vtp.string()));
  ParticleFrame const walls =
      options.walls.empty() ? ParticleFrame{} : read_drawable_frame(options.walls);
  FrameField const values = frame_field(frame, field);
  ColorRange const range = chosen_range(options, values.values);
  double const spacing = median_of_positive(spacings(frame));
  View const view = view_of(frame, walls, spacing);
  double const fallback = spacing > 0.0 ? spacing : 0.005 * std::max(view.width(), view.height());
  Layout layout(view);
  Axis const scale = color_scale(values, range);
  layout.fit_bar(range, scale);

  Canvas canvas(out, layout.page_width, layout.page_height);
  std::vector<Dot> dots =
      FramePicture(walls, view, layout).dots(fallback, [](std::size_t) { return wall_color; });
  std::vector<Dot> const particles =
      FramePicture(frame, view, layout).dots(fallback, [&](std::size_t i) {
        double const t = (values.values[i] - range.low) / (range.high - range.low);
        return viridis(std::round(t * color_levels) / color_levels);
      });
  dots.insert(dots.end(), particles.begin(), particles.end());
  draw_dots(canvas, layout.plot, dots);
  draw_title(canvas, layout, frame);
  draw_scales(canvas, view, layout, scale, range);
  canvas.finish();
}

}  // namespace moraine
