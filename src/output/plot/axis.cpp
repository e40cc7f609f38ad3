#include "output/plot/axis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "output/si_prefix.hpp"

namespace moraine::plot {
namespace {

constexpr double tick_length = 3.0;    // pt
constexpr double tick_gap = 6.0;       // pt, from the axis to the numbers
constexpr double label_offset = 12.0;  // pt, from the left end of the room to the label's middle
constexpr double line_spacing = 11.5;  // pt, between the lines of a label

struct Step {
  double size;
  int decimals;
};

/// Whether round values between the ends differ in double precision.
bool has_round_values(double low, double high) {
  double const length = high - low;
  return length > 1e-10 * std::max(std::abs(low), std::abs(high)) && std::isfinite(length);
}

Step round_step(double length, int most) {
  double const raw = length / std::max(most, 1);
  if (!(raw > 0.0) || !std::isfinite(raw)) return {0.0, 0};
  int const exponent = static_cast<int>(std::floor(std::log10(raw)));
  double const power = std::pow(10.0, exponent);
  for (double const factor : {1.0, 2.0, 2.5, 5.0})
    if (factor * power >= raw * (1.0 - 1e-9))
      return {factor * power, std::max(0, factor == 2.5 ? 1 - exponent : -exponent)};
  return {10.0 * power, std::max(0, -exponent - 1)};
}

/// A mark on a logarithmic axis: leading digit and power of ten.
struct Mark {
  int digit;
  int exponent;

  double value() const { return digit * std::pow(10.0, exponent); }
};

/// All digit * 10^(k stride) within [low, high].
std::vector<Mark> marks(double low, double high, std::vector<int> const& digits, int stride) {
  double const slack = 1e-9;
  std::vector<Mark> found;
  int const first = static_cast<int>(std::floor(std::log10(low)));
  int const last = static_cast<int>(std::ceil(std::log10(high)));
  for (int exponent = first; exponent <= last; ++exponent) {
    if (exponent % stride != 0) continue;
    for (int const digit : digits) {
      Mark const mark{digit, exponent};
      if (mark.value() >= low * (1.0 - slack) && mark.value() <= high * (1.0 + slack))
        found.push_back(mark);
    }
  }
  return found;
}

std::vector<Mark> fitting_marks(double low, double high, std::size_t most) {
  for (auto const& digits : {std::vector{1, 2, 5}, std::vector{1, 3}})
    if (auto const fine = marks(low, high, digits, 1); fine.size() <= most) return fine;
  for (int stride = 1;; ++stride)
    if (auto const coarse = marks(low, high, {1}, stride); coarse.size() <= most) return coarse;
}

std::string mark_text(Mark const& mark, bool decimal) {
  if (decimal) return fmt::format("{:.{}f}", mark.value(), std::max(0, -mark.exponent));
  std::string const power = power_of_ten(mark.exponent);
  return mark.digit == 1 ? power : fmt::format("{}·{}", mark.digit, power);
}

Ticks ticks_of(Axis const& axis, int most) {
  if (!axis.words.empty()) {
    Ticks ticks;
    for (std::string const& word : axis.words) {
      ticks.values.push_back(static_cast<double>(ticks.values.size()));
      ticks.labels.push_back(word);
    }
    return ticks;
  }
  return axis.scale == Scale::linear ? round_ticks(axis.low, axis.high, most)
                                     : log_ticks(axis.low, axis.high, most);
}

}  // namespace

double Axis::fraction(double value) const {
  if (scale == Scale::linear) return (value - low) / (high - low);
  return std::log(value / low) / std::log(high / low);
}

Ticks log_ticks(double low, double high, int most) {
  if (!(low > 0.0) || !has_round_values(low, high)) return {};
  if (marks(low, high, {1, 2, 5}, 1).size() < 3) return round_ticks(low, high, most);
  auto const found = fitting_marks(low, high, static_cast<std::size_t>(std::max(most, 1)) + 1);
  bool const decimal = found.front().exponent >= -3 && found.back().exponent < 5;
  Ticks ticks;
  for (Mark const& mark : found) {
    ticks.values.push_back(mark.value());
    ticks.labels.push_back(mark_text(mark, decimal));
  }
  return ticks;
}

Ticks round_ticks(double low, double high, int most) {
  Ticks ticks;
  if (!has_round_values(low, high)) return ticks;
  Step const step = round_step(high - low, most);
  double const slack = 1e-9 * (high - low);
  for (double k = std::ceil((low - slack) / step.size); k * step.size <= high + slack; k += 1.0) {
    std::string const digits = fmt::format("{:.{}f}", std::abs(k * step.size), step.decimals);
    ticks.values.push_back(k * step.size);
    ticks.labels.push_back(k < 0.0 ? "−" + digits : digits);
  }
  return ticks;
}

Axis axis_around(double low, double high, double margin, std::string label) {
  if (!(high > low)) {
    double const half = low == 0.0 ? 1.0 : 0.05 * std::abs(low);
    return {low - half, high + half, std::move(label), Scale::linear};
  }
  double const length = high - low;
  double const extra = margin * length;
  bool const zero_below = low >= 0.0 && low <= 0.3 * length;
  bool const zero_above = high <= 0.0 && -high <= 0.3 * length;
  return {zero_below ? 0.0 : low - extra, zero_above ? 0.0 : high + extra, std::move(label),
          Scale::linear};
}

Axis log_axis_around(double low, double high, double margin, std::string label) {
  if (!(low > 0.0) || !std::isfinite(high)) low = high = 1.0;
  double const extra = high > low ? std::pow(high / low, margin) : 10.0;
  return {low / extra, high * extra, std::move(label), Scale::logarithmic};
}

Axis rounded_out(Axis axis) {
  if (!has_round_values(axis.low, axis.high)) return axis;
  double const length = axis.high - axis.low;
  double const step = round_step(length, 8).size;
  double const low = std::floor(axis.low / step) * step, high = std::ceil(axis.high / step) * step;
  if (axis.low - low < 0.02 * length) axis.low = low;
  if (high - axis.high < 0.02 * length) axis.high = high;
  return axis;
}

std::string heading(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string axis_label(std::string_view name, std::string_view unit) {
  return unit.empty() ? heading(name) : fmt::format("{} ({})", heading(name), unit);
}

std::vector<std::string> label_lines(std::string const& label, double room) {
  if (text_width(label, label_style) <= room) return {label};
  std::size_t best = std::string::npos;
  double shortest = text_width(label, label_style);
  for (std::size_t at = label.find(' '); at != std::string::npos; at = label.find(' ', at + 1)) {
    double const longer = std::max(text_width(label.substr(0, at), label_style),
                                   text_width(label.substr(at + 1), label_style));
    if (longer < shortest) {
      shortest = longer;
      best = at;
    }
  }
  if (best == std::string::npos) return {label};
  return {label.substr(0, best), label.substr(best + 1)};
}

Ticks Panel::x_ticks() const {
  return ticks_of(x_, std::max(2, static_cast<int>(area_.width / 55.0)));
}

Ticks Panel::y_ticks() const {
  return ticks_of(y_, std::max(2, static_cast<int>(area_.height / 26.0)));
}

void Panel::draw_grid(Canvas& canvas) const {
  for (double const x : x_ticks().values)
    canvas.line(page_x(x), area_.top, page_x(x), area_.bottom(), grid_grey, 0.6);
  for (double const y : y_ticks().values)
    canvas.line(area_.left, page_y(y), area_.right(), page_y(y), grid_grey, 0.6);
}

double Panel::y_label_room() const {
  double widest = 0.0;
  for (std::string const& label : y_ticks().labels)
    widest = std::max(widest, text_width(label, tick_style));
  auto const lines = static_cast<double>(label_lines(y_.label, area_.height).size());
  return tick_gap + widest + 2.0 * label_offset + (lines - 1.0) * line_spacing;
}

double Panel::x_label_room() const {
  double longest = 0.0;
  for (std::string const& word : x_.words)
    longest = std::max(longest, text_width(word, tick_style));
  return longest + (longest > 0.0 ? tick_gap + 2.0 * label_offset : 38.0);
}

void Panel::draw_axes(Canvas& canvas, PanelText const& text, double room) const {
  canvas.outline(area_, ink, 0.7);
  TextStyle x_style = tick_style;
  x_style.align = x_.words.empty() ? Align::center : Align::right;
  x_style.upward = !x_.words.empty();
  double const below = x_.words.empty() ? 10.0 : tick_gap;
  Ticks const along_x = x_ticks();
  for (std::size_t i = 0; i < along_x.values.size(); ++i) {
    double const x = page_x(along_x.values[i]);
    canvas.line(x, area_.bottom(), x, area_.bottom() + tick_length, ink, 0.7);
    if (text.x_labels) canvas.text(x, area_.bottom() + below, along_x.labels[i], x_style);
  }
  TextStyle y_style = tick_style;
  y_style.align = Align::right;
  Ticks const along_y = y_ticks();
  for (std::size_t i = 0; i < along_y.values.size(); ++i) {
    double const y = page_y(along_y.values[i]);
    canvas.line(area_.left - tick_length, y, area_.left, y, ink, 0.7);
    if (text.y_labels) canvas.text(area_.left - tick_gap, y, along_y.labels[i], y_style);
  }
  TextStyle style = label_style;
  style.align = Align::center;
  if (text.x_labels)
    canvas.text(area_.left + area_.width / 2.0, area_.bottom() + x_label_room() - 13.0, x_.label,
                style);
  style.upward = true;
  if (!text.y_labels) return;
  double x = area_.left - room + label_offset;
  for (std::string const& line : label_lines(y_.label, area_.height)) {
    canvas.text(x, area_.top + area_.height / 2.0, line, style);
    x += line_spacing;
  }
}

}  // namespace moraine::plot
