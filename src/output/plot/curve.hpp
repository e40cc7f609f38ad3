// A line through many points.
#pragma once

#include <span>

#include "output/plot/axis.hpp"

namespace moraine::plot {

/// How a curve is drawn; `dashed` tells apart curves whose colours repeat.
struct CurveStyle {
  Color color = ink;
  double width = 1.2;  // pt
  bool dashed = false;
};

/// Draws y over x (both in displayed units, x ascending) inside the panel. Values that are not
/// finite, and those that a logarithmic axis does not have, leave a gap. Where several points fall
/// on a quarter of a point of the page, only the first, lowest, highest and last of them are drawn:
/// the picture stays the same, the file small.
void draw_curve(Canvas& canvas, Panel const& panel, std::span<double const> x,
                std::span<double const> y, CurveStyle const& style);

}  // namespace moraine::plot
