// The scale that says what the colours mean.
#pragma once

#include <string>
#include <vector>

#include "output/plot/axis.hpp"

namespace moraine::plot {

/// Range of the colours in SI units, and whether values lie outside of it.
struct ColorRange {
  double low = 0.0;
  double high = 1.0;
  bool below = false;
  bool above = false;
};

/// The range of all finite values, cut to the span from the 0.1 to the 99.9 per cent quantile where
/// this is less than a third of it. An empty range is widened.
ColorRange color_range(std::vector<double> const& values);

/// One range for several pictures: from the middle of their low ends to the middle of their high
/// ends; of two middle ones the outer. `ranges` must not be empty.
ColorRange common_range(std::vector<ColorRange> const& ranges);

/// Room that ticks and label of an upright bar need to its right [pt].
double upright_bar_room(Axis const& scale, double height);

/// Draws an upright bar in `area`, ticks and label to its right; triangular ends mean that values
/// lie outside. `scale` holds the range in displayed units and the label.
void draw_upright_bar(Canvas& canvas, Rect const& area, Axis const& scale, ColorRange const& range);

/// Draws a lying bar in `area`, ticks and label below.
void draw_lying_bar(Canvas& canvas, Rect const& area, Axis const& scale, ColorRange const& range);

}  // namespace moraine::plot
