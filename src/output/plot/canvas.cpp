#include "output/plot/canvas.hpp"

#include <cairo-svg.h>
#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "output/output_error.hpp"

namespace moraine::plot {
namespace {

bool is_vector(std::filesystem::path const& path) {
  if (path.extension() == ".svg") return true;
  if (path.extension() == ".png") return false;
  throw std::invalid_argument(
      fmt::format("a picture must end in .svg or .png: '{}'", path.string()));
}

void select(cairo_t* context, TextStyle const& style) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size);
}

}  // namespace

double text_width(std::string_view text, TextStyle const& style) {
  cairo_surface_t* const surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
  cairo_t* const context = cairo_create(surface);
  select(context, style);
  cairo_text_extents_t extents;
  cairo_text_extents(context, std::string(text).c_str(), &extents);
  cairo_destroy(context);
  cairo_surface_destroy(surface);
  return extents.x_advance;
}

Canvas::Canvas(std::filesystem::path path, double width, double height)
    : path_(std::move(path)),
      temporary_(path_),
      width_(width),
      height_(height),
      vector_(is_vector(path_)) {
  temporary_ += ".tmp";
  std::error_code ignored;  // a folder that could not be made shows when the file is written
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), ignored);
  if (vector_) {
    surface_.reset(cairo_svg_surface_create(temporary_.c_str(), width, height));
  } else {
    auto const pixels = [](double points) {
      return static_cast<int>(std::ceil(points * pixels_per_point));
    };
    surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height)));
    cairo_surface_set_device_scale(surface_.get(), pixels_per_point, pixels_per_point);
  }
  context_.reset(cairo_create(surface_.get()));
  if (cairo_status(cairo()) != CAIRO_STATUS_SUCCESS)
    throw OutputError(fmt::format("cannot write picture '{}': {}", path_.string(),
                                  cairo_status_to_string(cairo_status(cairo()))));
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo(), options);
  cairo_font_options_destroy(options);
  cairo_set_source_rgb(cairo(), 1.0, 1.0, 1.0);
  cairo_paint(cairo());
}

Canvas::~Canvas() {
  context_.reset();
  surface_.reset();  // an SVG surface writes until here
  if (finished_) return;
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void Canvas::set_color(Color const& color, double alpha) {
  cairo_set_source_rgba(cairo(), color.red, color.green, color.blue, alpha);
}

void Canvas::text(double x, double y, std::string_view text, TextStyle const& style) {
  select(cairo(), style);
  std::string const terminated(text);
  cairo_text_extents_t words, digit;
  cairo_text_extents(cairo(), terminated.c_str(), &words);
  cairo_text_extents(cairo(), "0", &digit);
  double shift = 0.0;
  if (style.align == Align::center) shift = -words.x_advance / 2.0;
  if (style.align == Align::right) shift = -words.x_advance;
  cairo_save(cairo());
  cairo_translate(cairo(), x, y);
  if (style.upward) cairo_rotate(cairo(), -std::numbers::pi / 2.0);
  cairo_move_to(cairo(), shift, digit.height / 2.0);
  set_color(style.color);
  cairo_show_text(cairo(), terminated.c_str());
  cairo_restore(cairo());
}

void Canvas::line(double x0, double y0, double x1, double y1, Color const& color, double width) {
  set_color(color);
  cairo_set_line_width(cairo(), width);
  cairo_move_to(cairo(), x0, y0);
  cairo_line_to(cairo(), x1, y1);
  cairo_stroke(cairo());
}

void Canvas::outline(Rect const& rect, Color const& color, double width) {
  set_color(color);
  cairo_set_line_width(cairo(), width);
  cairo_rectangle(cairo(), rect.left, rect.top, rect.width, rect.height);
  cairo_stroke(cairo());
}

void Canvas::finish() {
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  if (vector_) {
    cairo_surface_finish(surface_.get());
    status = cairo_surface_status(surface_.get());
  } else {
    status = cairo_surface_write_to_png(surface_.get(), temporary_.c_str());
  }
  std::error_code error;
  if (status == CAIRO_STATUS_SUCCESS) std::filesystem::rename(temporary_, path_, error);
  if (status != CAIRO_STATUS_SUCCESS || error)
    throw OutputError(fmt::format("cannot write picture '{}': {}", path_.string(),
                                  error ? error.message() : cairo_status_to_string(status)));
  finished_ = true;
}

}  // namespace moraine::plot
