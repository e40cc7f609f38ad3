#include "output/plot/curve.hpp"

#include <algorithm>
#include <cmath>

namespace moraine::plot {
namespace {

constexpr double column_width = 0.25;  // pt

/// Sends points of the page to cairo, thinned to four per column.
class ThinnedPath {
 public:
  explicit ThinnedPath(cairo_t* context) : context_(context) {}

  void add(double x, double y) {
    double const column = std::floor(x / column_width);
    if (count_ > 0 && column != column_) flush();
    column_ = column;
    if (count_ == 0) first_ = low_ = high_ = {x, y, order_};
    last_ = {x, y, order_};
    if (y < low_.y) low_ = last_;
    if (y > high_.y) high_ = last_;
    ++count_;
    ++order_;
  }

  /// Ends the current piece; the next point starts a new one.
  void lift() {
    flush();
    drawing_ = false;
  }

 private:
  struct Point {
    double x, y;
    std::size_t order;
  };

  void emit(Point const& point) {
    if (drawing_)
      cairo_line_to(context_, point.x, point.y);
    else
      cairo_move_to(context_, point.x, point.y);
    drawing_ = true;
  }

  void flush() {
    if (count_ == 0) return;
    bool const low_first = low_.order < high_.order;
    Point const points[] = {first_, low_first ? low_ : high_, low_first ? high_ : low_, last_};
    std::size_t previous = points[0].order;
    emit(points[0]);
    for (Point const& point : points)
      if (point.order > previous) {
        emit(point);
        previous = point.order;
      }
    count_ = 0;
  }

  cairo_t* context_;
  Point first_{}, low_{}, high_{}, last_{};
  double column_ = 0.0;
  std::size_t count_ = 0;
  std::size_t order_ = 0;
  bool drawing_ = false;
};

}  // namespace

void draw_curve(Canvas& canvas, Panel const& panel, std::span<double const> x,
                std::span<double const> y, CurveStyle const& style) {
  cairo_t* const context = canvas.cairo();
  Rect const& area = panel.area();
  cairo_save(context);
  cairo_rectangle(context, area.left, area.top, area.width, area.height);
  cairo_clip(context);
  canvas.set_color(style.color);
  cairo_set_line_width(context, style.width);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  double const dashes[] = {4.0, 2.0};
  if (style.dashed) cairo_set_dash(context, dashes, 2, 0.0);
  ThinnedPath path(context);
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    double const page_x = panel.page_x(x[i]), page_y = panel.page_y(y[i]);
    if (std::isfinite(page_x) && std::isfinite(page_y))
      path.add(page_x, page_y);
    else
      path.lift();
  }
  path.lift();
  cairo_stroke(context);
  cairo_restore(context);
}

}  // namespace moraine::plot
