#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "output/plot/color_map.hpp"
#include "output/plot/curve.hpp"
#include "output/plot/dots.hpp"
#include "output/plot/drawable.hpp"
#include "output/plot/frame_field.hpp"
#include "output/plot/plot.hpp"
#include "output/si_prefix.hpp"

namespace moraine {
namespace {

using namespace plot;

constexpr double top = 28.0, plot_width = 400.0, plot_height = 220.0;  // pt
constexpr double right_margin = 20.0, bottom_margin = 38.0;

/// Finite points (x, value) in displayed units, x ascending.
struct Profile {
  std::vector<double> x, y;
  Axis x_axis, y_axis;
};

DisplayUnit unit_of(std::vector<double> const& values, std::string const& unit) {
  double largest = 0.0;
  for (double const value : values) largest = std::max(largest, std::abs(value));
  return display_unit(unit, largest);
}

Profile make_profile(ParticleFrame const& frame, FrameField const& field) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < frame.size; ++i)
    if (std::isfinite(frame.points.values[3 * i]) && std::isfinite(field.values[i]))
      order.push_back(i);
  if (order.empty()) throw std::runtime_error("the frame has no particles to plot");
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return frame.points.values[3 * a] < frame.points.values[3 * b];
  });
  Profile profile;
  for (std::size_t const i : order) {
    profile.x.push_back(frame.points.values[3 * i]);
    profile.y.push_back(field.values[i]);
  }
  DisplayUnit const x_unit = unit_of(profile.x, "m"), y_unit = unit_of(profile.y, field.unit);
  for (double& x : profile.x) x /= x_unit.factor;
  for (double& y : profile.y) y /= y_unit.factor;
  auto const [low, high] = std::minmax_element(profile.y.begin(), profile.y.end());
  profile.x_axis = rounded_out(
      axis_around(profile.x.front(), profile.x.back(), 0.0, fmt::format("x ({})", x_unit.unit)));
  profile.y_axis = axis_around(*low, *high, 0.06, axis_label(field.name, y_unit.unit));
  return profile;
}

}  // namespace

void plot_profile(std::filesystem::path const& vtp, std::string const& field,
                  std::filesystem::path const& out) {
  ParticleFrame const frame = read_drawable_frame(vtp);
  Profile const profile = make_profile(frame, frame_field(frame, field));
  double const left =
      Panel({0.0, 0.0, plot_width, plot_height}, profile.x_axis, profile.y_axis).y_label_room();
  Rect const area{left, top, plot_width, plot_height};
  Panel const panel(area, profile.x_axis, profile.y_axis);

  Canvas canvas(out, area.right() + right_margin, area.bottom() + bottom_margin);
  panel.draw_grid(canvas);
  Color const color = line_color(0);
  if (frame.dimension == 1)
    draw_curve(canvas, panel, profile.x, profile.y, {.color = color, .width = 0.9});
  std::vector<Dot> dots;
  for (std::size_t i = 0; i < profile.x.size(); ++i)
    dots.push_back({panel.page_x(profile.x[i]), panel.page_y(profile.y[i]), 2.2, color});
  draw_dots(canvas, area, dots);
  panel.draw_axes(canvas, {}, left);
  TextStyle style = label_style;
  style.bold = true;
  canvas.text(left, 16.0, "t = " + with_unit(frame.time, "s"), style);
  canvas.finish();
}

}  // namespace moraine
