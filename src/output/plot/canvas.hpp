// A page to draw on: SVG or PNG, with the few text and line helpers that plots need.
#pragma once

#include <cairo.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace moraine::plot {

struct Color {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
};

inline constexpr Color ink{0.13, 0.13, 0.15};
inline constexpr Color grey{0.45, 0.45, 0.48};
inline constexpr Color grid_grey{0.90, 0.90, 0.91};

/// A rectangle on the page [pt], y downwards.
struct Rect {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

/// Where the anchor of a text lies in it, horizontally; vertically it is the middle of the digits.
enum class Align { left, center, right };

struct TextStyle {
  double size = 9.0;  // pt
  Color color = ink;
  Align align = Align::left;
  bool bold = false;
  bool upward = false;  // turned by 90 degrees, to be read from the right
};

/// Resolution of PNG pages and of pictures inside SVG pages.
inline constexpr double pixels_per_point = 200.0 / 72.0;

/// Length of a text [pt].
double text_width(std::string_view text, TextStyle const& style);

/// A white page of the given size [pt]. The file ending decides the format: ".svg" or ".png";
/// anything else throws std::invalid_argument. Text in SVG becomes outlines, so it looks the same
/// everywhere. Nothing is left behind without `finish`.
class Canvas {
 public:
  Canvas(std::filesystem::path path, double width, double height);
  ~Canvas();
  Canvas(Canvas const&) = delete;
  Canvas& operator=(Canvas const&) = delete;

  cairo_t* cairo() { return context_.get(); }
  bool vector() const { return vector_; }
  double width() const { return width_; }
  double height() const { return height_; }

  void set_color(Color const& color, double alpha = 1.0);
  void text(double x, double y, std::string_view text, TextStyle const& style);
  void line(double x0, double y0, double x1, double y1, Color const& color, double width);
  void outline(Rect const& rect, Color const& color, double width);

  /// Writes the file (complete or not at all). Throws std::runtime_error if that fails.
  void finish();

 private:
  struct FreeContext {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  struct FreeSurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  double width_;
  double height_;
  bool vector_;
  std::unique_ptr<cairo_surface_t, FreeSurface> surface_;
  std::unique_ptr<cairo_t, FreeContext> context_;
  bool finished_ = false;
};

}  // namespace moraine::plot
