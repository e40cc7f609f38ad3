#include "output/plot/color_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace moraine::plot {
namespace {

constexpr std::array<Color, 17> viridis_table{{
    {0.267004, 0.004874, 0.329415},
    {0.282327, 0.094955, 0.417331},
    {0.278826, 0.175490, 0.483397},
    {0.258965, 0.251537, 0.524736},
    {0.229739, 0.322361, 0.545706},
    {0.199430, 0.387607, 0.554642},
    {0.172719, 0.448791, 0.557885},
    {0.149039, 0.508051, 0.557250},
    {0.127568, 0.566949, 0.550556},
    {0.120638, 0.625828, 0.533488},
    {0.157851, 0.683765, 0.501686},
    {0.246070, 0.738910, 0.452024},
    {0.369214, 0.788888, 0.382914},
    {0.515992, 0.831158, 0.294279},
    {0.678489, 0.863742, 0.189503},
    {0.845561, 0.887322, 0.099702},
    {0.993248, 0.906157, 0.143936},
}};

constexpr std::array<Color, 7> line_colors{{
    {0.000, 0.447, 0.698},  // blue
    {0.835, 0.369, 0.000},  // vermillion
    {0.000, 0.620, 0.451},  // bluish green
    {0.800, 0.475, 0.655},  // reddish purple
    {0.902, 0.624, 0.000},  // orange
    {0.337, 0.706, 0.914},  // sky blue
    {0.350, 0.350, 0.350},  // grey, in place of black
}};

}  // namespace

Color viridis(double t) {
  if (std::isnan(t)) return {0.5, 0.5, 0.5};
  double const place = std::clamp(t, 0.0, 1.0) * 16.0;
  auto const below = std::min(static_cast<std::size_t>(place), std::size_t{15});
  double const part = place - static_cast<double>(below);
  Color const& a = viridis_table[below];
  Color const& b = viridis_table[below + 1];
  return {std::lerp(a.red, b.red, part), std::lerp(a.green, b.green, part),
          std::lerp(a.blue, b.blue, part)};
}

Color line_color(std::size_t index) { return line_colors[index % line_colors.size()]; }

}  // namespace moraine::plot
