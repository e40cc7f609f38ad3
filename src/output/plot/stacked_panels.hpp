// Several panels of curves over the same x axis on one page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/plot/axis.hpp"

namespace moraine::plot {

/// A curve in the units of its panel.
struct Curve {
  std::string name;  // in the legend, unless empty; curves of the same name share a colour
  std::vector<double> values;
  bool faint = false;  // thin and dashed; shapes no axis where there are others
  bool broad = false;  // seen on both sides of a curve that lies on it
};

/// Curves of one quantity.
struct CurvePanel {
  std::string quantity;  // "pressure"
  std::string unit;      // SI on a linear axis, which chooses a prefix; any on a logarithmic one
  std::vector<Curve> curves;
  Scale scale = Scale::linear;
  std::vector<double> shown_values{};  // that the axis shows too
};

/// Draws panels of equal size below one another with a common legend on top. `x` is the common
/// axis; its unit is like that of a panel. `columns`: 0 means two for more than four panels, else
/// one.
void draw_stacked_panels(std::filesystem::path const& out, std::string const& title, Curve const& x,
                         std::string const& x_unit, std::vector<CurvePanel> const& panels,
                         Scale x_scale = Scale::linear, std::size_t columns = 0);

}  // namespace moraine::plot
