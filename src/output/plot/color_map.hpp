// Colours for values.
#pragma once

#include "output/plot/canvas.hpp"

namespace moraine::plot {

/// The perceptually uniform map "viridis" at t in [0, 1] (clamped; NaN gives mid grey).
///
/// Interpolates every sixteenth entry of the 256-entry table by N. Smith and S. van der Walt
/// (matplotlib, _cm_listed.py, CC0); off the table by less than 0.025 per channel.
Color viridis(double t);

/// Colours of lines that stay apart for colour-blind readers: M. Okabe, K. Ito, "Color Universal
/// Design", 2008, without black and yellow; repeats after seven.
Color line_color(std::size_t index);

}  // namespace moraine::plot
