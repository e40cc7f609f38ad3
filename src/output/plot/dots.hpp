// Many coloured discs.
#pragma once

#include <cstddef>
#include <vector>

#include "output/plot/canvas.hpp"

namespace moraine::plot {

/// A disc on the page.
struct Dot {
  double x;         // pt
  double y;         // pt
  double diameter;  // pt
  Color color;
};

/// Above this number dots are drawn as one picture: a vector file of so many would be slow to open.
inline constexpr std::size_t most_vector_dots = 20000;

/// Draws the dots in their order, clipped to `area`. On a vector page with few dots they are
/// outlines, otherwise a picture of `pixels_per_point`.
void draw_dots(Canvas& canvas, Rect const& area, std::vector<Dot> const& dots);

}  // namespace moraine::plot
