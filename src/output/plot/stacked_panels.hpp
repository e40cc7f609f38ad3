// Several panels of curves over the same x axis on one page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moraine::plot {

/// A curve in SI units.
struct Curve {
  std::string name;  // in the legend, unless empty; curves of the same name share a colour
  std::vector<double> values;
};

/// Curves of one quantity.
struct CurvePanel {
  std::string quantity;  // "pressure"
  std::string unit;      // SI
  std::vector<Curve> curves;
};

/// Draws panels of equal size below one another (in two columns for more than four) with a common
/// legend on top. `x` is the common axis in SI units.
void draw_stacked_panels(std::filesystem::path const& out, std::string const& title, Curve const& x,
                         std::string const& x_unit, std::vector<CurvePanel> const& panels);

}  // namespace moraine::plot
