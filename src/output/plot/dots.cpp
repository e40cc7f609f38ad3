#include "output/plot/dots.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace moraine::plot {
namespace {

constexpr int samples = 2;  // per pixel and direction, against jagged edges

bool same_pen(Dot const& a, Dot const& b) {
  return a.diameter == b.diameter && a.color.red == b.color.red && a.color.green == b.color.green &&
         a.color.blue == b.color.blue;
}

/// A dot is a line of no length with a round end: the shortest way to say it in SVG. Neighbours in
/// the order with the same pen share one path.
void draw_outlines(Canvas& canvas, std::vector<Dot> const& dots) {
  cairo_t* const context = canvas.cairo();
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  for (std::size_t i = 0; i < dots.size(); ++i) {
    cairo_move_to(context, dots[i].x, dots[i].y);
    cairo_line_to(context, dots[i].x, dots[i].y);
    if (i + 1 < dots.size() && same_pen(dots[i], dots[i + 1])) continue;
    canvas.set_color(dots[i].color);
    cairo_set_line_width(context, dots[i].diameter);
    cairo_stroke(context);
  }
}

/// A picture of fully covered or empty pixels; smoothing comes from drawing it smaller.
class Picture {
 public:
  Picture(Rect const& area, double scale)
      : left_(area.left),
        top_(area.top),
        scale_(scale),
        width_(std::max(1, static_cast<int>(std::ceil(area.width * scale)))),
        height_(std::max(1, static_cast<int>(std::ceil(area.height * scale)))),
        pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0U) {}

  void fill(Dot const& dot) {
    double const x = (dot.x - left_) * scale_, y = (dot.y - top_) * scale_;
    double const radius = std::max(0.5 * dot.diameter * scale_, 0.71);
    std::uint32_t const value = packed(dot.color);
    int const first = first_from(y - radius - 0.5);
    int const last = last_to(y + radius - 0.5, height_);
    for (int row = first; row <= last; ++row) {
      double const dy = row + 0.5 - y;
      double const half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
      int const from = first_from(x - half - 0.5);
      int const to = last_to(x + half - 0.5, width_);
      std::uint32_t* const line =
          pixels_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
      for (int column = from; column <= to; ++column) line[column] = value;
    }
  }

  /// Draws the picture with its upper left corner at the origin, `shrink` times smaller.
  void draw(cairo_t* context, double shrink) {
    cairo_surface_t* const surface =
        cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels_.data()),
                                            CAIRO_FORMAT_ARGB32, width_, height_, width_ * 4);
    cairo_save(context);
    cairo_scale(context, 1.0 / shrink, 1.0 / shrink);
    cairo_set_source_surface(context, surface, 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_GOOD);
    cairo_paint(context);
    cairo_restore(context);
    cairo_surface_destroy(surface);
  }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  // Pixels from and to a place, within the picture; places far outside are no int.
  static int first_from(double place) {
    return static_cast<int>(std::clamp(std::ceil(place), 0.0, 1e9));
  }
  static int last_to(double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), -1.0, count - 1.0));
  }

  static std::uint32_t packed(Color const& color) {
    auto const byte = [](double part) {
      return static_cast<std::uint32_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255.0));
    };
    return 0xFF000000U | byte(color.red) << 16 | byte(color.green) << 8 | byte(color.blue);
  }

  double left_, top_, scale_;
  int width_, height_;
  std::vector<std::uint32_t> pixels_;
};

void draw_picture(Canvas& canvas, Rect const& area, std::vector<Dot> const& dots) {
  Picture fine(area, pixels_per_point * samples);
  for (Dot const& dot : dots) fine.fill(dot);

  cairo_surface_t* const surface =
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, (fine.width() + samples - 1) / samples,
                                 (fine.height() + samples - 1) / samples);
  cairo_t* const shrinking = cairo_create(surface);
  fine.draw(shrinking, samples);
  cairo_destroy(shrinking);

  cairo_t* const context = canvas.cairo();
  cairo_save(context);
  cairo_translate(context, area.left, area.top);
  cairo_scale(context, 1.0 / pixels_per_point, 1.0 / pixels_per_point);
  cairo_set_source_surface(context, surface, 0.0, 0.0);
  cairo_paint(context);
  cairo_restore(context);
  cairo_surface_destroy(surface);
}

}  // namespace

void draw_dots(Canvas& canvas, Rect const& area, std::vector<Dot> const& dots) {
  cairo_t* const context = canvas.cairo();
  cairo_save(context);
  cairo_rectangle(context, area.left, area.top, area.width, area.height);
  cairo_clip(context);
  if (canvas.vector() && dots.size() <= most_vector_dots)
    draw_outlines(canvas, dots);
  else
    draw_picture(canvas, area, dots);
  cairo_restore(context);
}

}  // namespace moraine::plot
