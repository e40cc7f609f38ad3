// Axes: round ticks, labels, and the map from values to the page.
#pragma once

#include <string>
#include <vector>

#include "output/plot/canvas.hpp"

namespace moraine::plot {

/// Marks at round values within [low, high] and their texts, all with the same decimals.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
};

/// At most `most` + 1 ticks, at multiples of 1, 2, 2.5 or 5 times a power of ten. None where the
/// interval is too short for the digits of its ends.
Ticks round_ticks(double low, double high, int most);

/// Marks within [low, high] > 0 for a logarithmic axis, at most `most` + 1: 1, 2 and 5 times the
/// powers of ten, else 1 and 3 times, else the powers, else every second, third ... power. Where an
/// interval holds less than three of the first: round_ticks. Texts are decimals where all values
/// are from 0.001 to below 100 000, powers of ten otherwise.
Ticks log_ticks(double low, double high, int most);

/// How values are spread along an axis.
enum class Scale { linear, logarithmic };

/// Interval of displayed values, with its label. 0 < low < high on a logarithmic axis.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::string label;  // "Pressure (MPa)"
  Scale scale = Scale::linear;
  std::vector<std::string> words{};  // where there are any: the texts at 0, 1, 2 ..., no numbers

  /// Where a value lies between the ends, 0 to 1; not finite for values that a logarithmic axis
  /// does not have.
  double fraction(double value) const;
};

/// The interval that shows all values from low to high with a margin of `margin` of its length;
/// zero is included where it is near, and an empty interval is widened.
Axis axis_around(double low, double high, double margin, std::string label);

/// The logarithmic axis that shows all values from low to high with a margin of `margin` of its
/// length; an interval without length is widened, and one without positive values becomes 0.1
/// to 10.
Axis log_axis_around(double low, double high, double margin, std::string label);

/// The same axis with each end moved out to a round value where one lies within 2 % of its length.
Axis rounded_out(Axis axis);

/// "wall_pressure" becomes "Wall pressure".
std::string heading(std::string_view name);

/// The lines in which a label is written: one, or two of about equal length where it is wider than
/// `room` [pt] and has a blank to break at.
std::vector<std::string> label_lines(std::string const& label, double room);

/// "Pressure (MPa)"; the name alone for an empty unit.
std::string axis_label(std::string_view name, std::string_view unit);

/// Which of its labels a panel writes.
struct PanelText {
  bool x_labels = true;
  bool y_labels = true;
};

/// A plotting area with its axes.
class Panel {
 public:
  Panel(Rect const& area, Axis x, Axis y) : area_(area), x_(std::move(x)), y_(std::move(y)) {}

  Rect const& area() const { return area_; }
  double page_x(double x) const { return area_.left + x_.fraction(x) * area_.width; }
  double page_y(double y) const { return area_.bottom() - y_.fraction(y) * area_.height; }

  /// Grid lines, below the data.
  void draw_grid(Canvas& canvas) const;
  /// Axis lines, ticks and labels, above the data. The rotated label stands at the left end of the
  /// `room` [pt] to the left of the area, in two lines where one is longer than the area is high.
  void draw_axes(Canvas& canvas, PanelText const& text, double room) const;
  /// Room that ticks and label need to the left of the area [pt].
  double y_label_room() const;
  /// Room that ticks and label need below the area [pt].
  double x_label_room() const;

 private:
  Ticks x_ticks() const;
  Ticks y_ticks() const;

  Rect area_;
  Axis x_;
  Axis y_;
};

inline constexpr TextStyle tick_style{.size = 8.5, .color = ink};
inline constexpr TextStyle label_style{.size = 9.5, .color = ink};

}  // namespace moraine::plot
