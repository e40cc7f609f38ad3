#include "output/plot/plot_preview.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "output/plot/axis.hpp"
#include "output/plot/color_map.hpp"
#include "output/plot/dots.hpp"
#include "output/si_prefix.hpp"

namespace moraine {
namespace {

using namespace plot;

constexpr Color wall_color{0.72, 0.72, 0.74};
constexpr double left_room = 54.0, below_room = 38.0, gap = 12.0, legend_row = 14.0;
constexpr double widest = 400.0, widest_of_three = 230.0, highest = 420.0;
constexpr double overlap = 1.1;  // of the discs over their spacing

/// The axes of a view, and the one that it looks along.
struct Look {
  std::size_t across, up, along;
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double size() const { return high - low; }
};

class Picture {
 public:
  explicit Picture(Preview const& preview) : preview_(preview) {
    measure();
    if (preview.dimension == 3)
      looks_ = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}};
    else
      looks_ = {{0, 1, 2}};
    double width = 0.0, height = 0.0;
    for (Look const& look : looks_) {
      width = std::max(width, extent_[look.across].size());
      height = std::max(height, extent_[look.up].size());
    }
    double const most = looks_.size() > 1 ? widest_of_three : widest;
    to_page_ = std::min(most / width, highest / height);
    top_ = 12.0 + legend_row * static_cast<double>(preview.regions.size() + 1);
    page_width_ = gap;
    for (Look const& look : looks_) page_width_ += left_room + panel_width(look) + gap;
    page_width_ = std::max(page_width_, 300.0);
    page_height_ = top_ + height * to_page_ + below_room + (looks_.size() > 1 ? legend_row : 0.0);
  }

  void draw(std::filesystem::path const& out) const {
    Canvas canvas(out, page_width_, page_height_);
    draw_legend(canvas);
    double left = 0.0;
    for (Look const& look : looks_) {
      left += left_room;
      draw_view(canvas, look, left);
      left += panel_width(look) + gap;
    }
    canvas.finish();
  }

 private:
  double panel_width(Look const& look) const { return extent_[look.across].size() * to_page_; }

  void measure() {
    auto const include = [this](std::vector<Vec3> const& points) {
      for (Vec3 const& point : points)
        for (std::size_t axis = 0; axis < 3; ++axis) extent_[axis].include(point[axis]);
    };
    for (auto const& region : preview_.regions) include(region.positions);
    include(preview_.walls);
    for (auto const& probe : preview_.probes) include(probe.positions);
    double longest = 0.0;
    for (Range const& range : extent_) longest = std::max(longest, range.size());
    for (Range& range : extent_) {
      double const margin =
          std::max(preview_.spacing, range.size() > 0.0 ? 0.02 * longest : 0.05 * longest);
      range.low -= margin;
      range.high += margin;
    }
  }

  Color color_of(std::size_t region) const { return line_color(region); }

  bool shows(Look const& look, Vec3 const& point, double spacing) const {
    if (preview_.dimension < 3) return true;
    double const from = point[look.along] - preview_.at[look.along];
    return from >= -0.5 * spacing && from < 0.5 * spacing;
  }

  double spacing_of(PreviewPart const& part) const {
    return part.spacing > 0.0 ? part.spacing : preview_.spacing;
  }

  void add_dots(std::vector<Dot>& dots, Look const& look, Panel const& panel,
                std::vector<Vec3> const& points, double spacing, Color const& color,
                double unit) const {
    for (Vec3 const& point : points)
      if (shows(look, point, spacing))
        dots.push_back({panel.page_x(point[look.across] / unit),
                        panel.page_y(point[look.up] / unit), overlap * spacing * to_page_, color});
  }

  void draw_view(Canvas& canvas, Look const& look, double left) const {
    Range const& x = extent_[look.across];
    Range const& y = extent_[look.up];
    DisplayUnit const length = display_unit("m", std::max(x.size(), y.size()));
    auto const axis = [&](std::size_t direction, Range const& range) {
      return Axis{range.low / length.factor, range.high / length.factor,
                  fmt::format("{} ({})", "xyz"[direction], length.unit)};
    };
    Panel const panel({left, top_, panel_width(look), y.size() * to_page_}, axis(look.across, x),
                      axis(look.up, y));
    std::vector<Dot> dots;
    add_dots(dots, look, panel, preview_.walls, preview_.spacing, wall_color, length.factor);
    for (std::size_t i = 0; i < preview_.regions.size(); ++i)
      add_dots(dots, look, panel, preview_.regions[i].positions, spacing_of(preview_.regions[i]),
               color_of(i), length.factor);
    draw_dots(canvas, panel.area(), dots);
    draw_probes(canvas, look, panel, length.factor);
    panel.draw_axes(canvas, {true, preview_.dimension > 1},
                    std::min(left_room, panel.y_label_room()));
    if (preview_.dimension == 3)
      canvas.text(left, panel.area().bottom() + below_room,
                  fmt::format("slice at {} = {}", "xyz"[look.along],
                              with_unit(preview_.at[look.along], "m")),
                  tick_style);
  }

  void draw_probes(Canvas& canvas, Look const& look, Panel const& panel, double unit) const {
    constexpr double arm = 4.0;
    for (auto const& probe : preview_.probes)
      for (Vec3 const& point : probe.positions) {
        double const x = panel.page_x(point[look.across] / unit);
        double const y = panel.page_y(point[look.up] / unit);
        canvas.line(x - arm, y, x + arm, y, ink, 1.2);
        canvas.line(x, y - arm, x, y + arm, ink, 1.2);
        canvas.text(x + arm + 1.0, y - arm - 1.0, probe.name, tick_style);
      }
  }

  void draw_legend(Canvas& canvas) const {
    double y = 14.0;
    auto const row = [&](Color const& color, std::string const& text) {
      draw_dots(canvas, {0.0, 0.0, page_width_, page_height_}, {{left_room + 4.0, y, 8.0, color}});
      canvas.text(left_room + 14.0, y, text, tick_style);
      y += legend_row;
    };
    for (std::size_t i = 0; i < preview_.regions.size(); ++i)
      row(color_of(i), fmt::format("{}: {} particles", preview_.regions[i].name,
                                   preview_.regions[i].positions.size()));
    if (!preview_.walls.empty())
      row(wall_color, fmt::format("walls: {} particles", preview_.walls.size()));
  }

  Preview const& preview_;
  std::vector<Look> looks_;
  std::array<Range, 3> extent_;
  double to_page_ = 1.0;  // pt/m
  double top_ = 0.0, page_width_ = 0.0, page_height_ = 0.0;
};

}  // namespace

void plot_preview(Preview const& preview, std::filesystem::path const& out) {
  Picture(preview).draw(out);
}

}  // namespace moraine
