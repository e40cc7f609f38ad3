#include "sweep/sweep_plots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "output/plot/color_map.hpp"
#include "output/plot/curve.hpp"
#include "output/plot/dots.hpp"
#include "output/si_prefix.hpp"

namespace moraine {
namespace {

using namespace plot;

constexpr double panel_width = 400.0, panel_height = 128.0;  // pt
constexpr double least_left = 56.0, right_margin = 16.0, gap = 14.0, title_height = 30.0;
constexpr double legend_row = 13.0;
constexpr std::size_t most_lines = 14;  // more are told apart no longer
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Members that differ only along the axis of the picture.
struct Series {
  std::string name;
  std::vector<std::pair<double, std::size_t>> points;  // place along the axis, member
};

std::string text_of(std::variant<double, std::string> const& value, std::string const& unit) {
  if (auto const* text = std::get_if<std::string>(&value)) return *text;
  return with_unit(std::get<double>(value), unit, 4);
}

/// An axis of the plan in its picture.
class PlotAxis {
 public:
  PlotAxis(SweepPlan const& plan, SweepTable const& table, std::size_t axis)
      : axis_(plan.axes[axis]), joined_(plan.method != SweepMethod::latin_hypercube) {
    for (std::size_t a = 0; a < axis; ++a) first_ += plan.axes[a].columns.size();
    if (plan.method != SweepMethod::grid)
      own_ = table.parameters.size();
    else
      own_ = axis_.columns.size();
    find_series(table);
  }

  std::vector<Series> const& series() const { return series_; }
  bool joined() const { return joined_ && words_.empty() && series_.size() <= most_lines; }
  bool named() const { return series_.size() > 1 && series_.size() <= most_lines; }

  /// The horizontal axis and the factor between its numbers and SI.
  std::pair<Axis, double> axis() const {
    SweepColumn const& column = axis_.columns.front();
    if (!words_.empty())
      return {{-0.5, static_cast<double>(words_.size()) - 0.5, heading(column.label), Scale::linear,
               words_},
              1.0};
    auto const [low, high] = range();
    if (axis_.logarithmic)
      return {log_axis_around(low, high, 0.04, axis_label(column.label, typeset_unit(column.unit))),
              1.0};
    DisplayUnit const shown = display_unit(column.unit, std::max(std::abs(low), std::abs(high)));
    return {axis_around(low / shown.factor, high / shown.factor, 0.04,
                        axis_label(column.label, shown.unit)),
            shown.factor};
  }

 private:
  void find_series(SweepTable const& table) {
    std::map<std::string, std::size_t> known;
    for (std::size_t m = 0; m < table.members.size(); ++m) {
      auto const& member = table.members[m];
      std::string key, name;
      for (std::size_t c = 0; c < member.values.size(); ++c) {
        if (own_ == member.values.size() || (c >= first_ && c < first_ + own_)) continue;
        auto const& heading = table.parameters[c];
        std::string const text = text_of(member.values[c], heading.unit);
        key += text + '\n';
        if (varies(table, c))
          name += fmt::format("{}{} {}", name.empty() ? "" : ", ", heading.label, text);
      }
      auto const [found, added] = known.emplace(key, series_.size());
      if (added) series_.push_back({name, {}});
      double const place = place_of(member.values[first_]);
      if (std::isfinite(place)) series_[found->second].points.emplace_back(place, m);
    }
    for (Series& one : series_) std::stable_sort(one.points.begin(), one.points.end());
  }

  static bool varies(SweepTable const& table, std::size_t column) {
    return std::any_of(table.members.begin(), table.members.end(), [&](auto const& member) {
      return member.values[column] != table.members.front().values[column];
    });
  }

  double place_of(std::variant<double, std::string> const& value) {
    if (auto const* number = std::get_if<double>(&value)) return *number;
    std::string const& word = std::get<std::string>(value);
    auto const found = std::find(words_.begin(), words_.end(), word);
    auto const place = static_cast<double>(found - words_.begin());
    if (found == words_.end()) words_.push_back(word);
    return place;
  }

  std::pair<double, double> range() const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Series const& one : series_)
      for (auto const& [place, member] : one.points) {
        low = std::min(low, place);
        high = std::max(high, place);
      }
    return low <= high ? std::pair(low, high) : std::pair(0.0, 0.0);
  }

  SweepAxis const& axis_;
  bool joined_;
  std::size_t first_ = 0;  // column
  std::size_t own_ = 0;    // columns
  std::vector<std::string> words_;
  std::vector<Series> series_;
};

double output_of(SweepTable const& table, std::size_t member, std::size_t output) {
  auto const& outputs = table.members[member].outputs;
  return output < outputs.size() ? outputs[output].value_or(nothing) : nothing;
}

std::pair<Axis, double> value_axis(SweepTable const& table, std::size_t output) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t m = 0; m < table.members.size(); ++m) {
    double const value = output_of(table, m, output);
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low <= high)) low = high = 0.0;
  auto const& column = table.outputs[output];
  DisplayUnit const shown = display_unit(column.unit, std::max(std::abs(low), std::abs(high)));
  return {axis_around(low / shown.factor, high / shown.factor, 0.08,
                      axis_label(column.label, shown.unit)),
          shown.factor};
}

class SweepPicture {
 public:
  SweepPicture(SweepTable const& table, PlotAxis const& along) : table_(table), along_(along) {
    std::tie(x_, x_factor_) = along.axis();
    for (std::size_t o = 0; o < table.outputs.size(); ++o)
      left_ = std::max(left_, Panel(area_at(0.0), x_, value_axis(table, o).first).y_label_room());
    top_ = title_height;
    if (along.named()) top_ += legend_row * static_cast<double>(along.series().size());
  }

  void draw(std::filesystem::path const& file) const {
    auto const panels = static_cast<double>(table_.outputs.size());
    Panel const lowest(area_at(0.0), x_, Axis{});
    Canvas canvas(file, left_ + panel_width + right_margin,
                  top_ + panels * panel_height + (panels - 1.0) * gap + lowest.x_label_room());
    TextStyle title = label_style;
    title.bold = true;
    canvas.text(left_, 15.0, table_.title, title);
    if (along_.named()) draw_legend(canvas);
    for (std::size_t o = 0; o < table_.outputs.size(); ++o) draw_panel(canvas, o);
    canvas.finish();
  }

 private:
  Rect area_at(double top) const { return {left_, top, panel_width, panel_height}; }

  void draw_legend(Canvas& canvas) const {
    for (std::size_t s = 0; s < along_.series().size(); ++s) {
      double const y = title_height + (static_cast<double>(s) + 0.2) * legend_row;
      canvas.line(left_, y, left_ + 17.0, y, line_color(s), 1.8);
      canvas.text(left_ + 22.0, y, along_.series()[s].name, tick_style);
    }
  }

  void draw_panel(Canvas& canvas, std::size_t output) const {
    auto const [axis, factor] = value_axis(table_, output);
    Panel const panel(area_at(top_ + static_cast<double>(output) * (panel_height + gap)), x_, axis);
    panel.draw_grid(canvas);
    std::vector<Dot> dots;
    for (std::size_t s = 0; s < along_.series().size(); ++s) {
      std::vector<double> x, y;
      for (auto const& [place, member] : along_.series()[s].points) {
        x.push_back(place / x_factor_);
        y.push_back(output_of(table_, member, output) / factor);
        if (std::isfinite(y.back()))
          dots.push_back({panel.page_x(x.back()), panel.page_y(y.back()), 5.0, color(s)});
      }
      if (along_.joined())
        draw_curve(canvas, panel, x, y, {.color = color(s), .width = 1.0, .dashed = s >= 7});
    }
    draw_dots(canvas, panel.area(), dots);
    bool const lowest = output + 1 == table_.outputs.size();
    panel.draw_axes(canvas, {.x_labels = lowest, .y_labels = true}, left_);
  }

  Color color(std::size_t series) const { return line_color(along_.named() ? series : 0); }

  SweepTable const& table_;
  PlotAxis const& along_;
  Axis x_;
  double x_factor_ = 1.0;
  double left_ = least_left;
  double top_ = 0.0;
};

std::string file_name(std::string const& label) {
  std::string name;
  for (char const c : label)
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' ? c : '_';
  return fmt::format("sweep_{}.png", name);
}

}  // namespace

std::vector<std::filesystem::path> plot_sweep(SweepPlan const& plan, SweepTable const& table,
                                              std::filesystem::path const& folder) {
  std::vector<std::filesystem::path> files;
  bool const results = std::any_of(table.members.begin(), table.members.end(), [](auto const& m) {
    return m.state == SweepTable::State::done;
  });
  if (table.outputs.empty() || !results) return files;
  std::filesystem::create_directories(folder);
  for (std::size_t a = 0; a < plan.axes.size(); ++a) {
    if (!plan.axes[a].varies()) continue;
    PlotAxis const along(plan, table, a);
    files.push_back(folder / file_name(plan.axes[a].columns.front().label));
    SweepPicture(table, along).draw(files.back());
  }
  return files;
}

}  // namespace moraine
