// Named Riemann problems of an ideal gas.
#pragma once

#include <array>
#include <string_view>

#include "exact/riemann_ideal_gas.hpp"

namespace moraine {

/// A tube from x = 0 to 1 with a membrane, and the time at which solutions are usually shown.
struct ShockTube {
  std::string_view name;
  std::string_view meaning;
  GasState left;
  GasState right;
  double membrane;  // m
  double time;      // s
};

/// All of them have a heat capacity ratio of 1.4. toro-1 to toro-5 are those of Toro, Riemann
/// Solvers and Numerical Methods for Fluid Dynamics, 3rd ed. (2009), table 4.1, with the times and
/// membranes of its figures 4.7 to 4.11; sod is Sod, J. Comput. Phys. 27 (1978) 1: toro-1 is the
/// same.
inline constexpr std::array<ShockTube, 6> shock_tubes{{
    {"sod", "mild shock tube", {1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, 0.5, 0.2},
    {"toro-1", "Sod's shock tube", {1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, 0.5, 0.25},
    {"toro-2", "two rarefactions, near vacuum", {1.0, -2.0, 0.4}, {1.0, 2.0, 0.4}, 0.5, 0.15},
    {"toro-3", "strong shock to the right", {1.0, 0.0, 1000.0}, {1.0, 0.0, 0.01}, 0.5, 0.012},
    {"toro-4", "strong shock to the left", {1.0, 0.0, 0.01}, {1.0, 0.0, 100.0}, 0.5, 0.035},
    {"toro-5",
     "two strong shocks meet",
     {5.99924, 19.5975, 460.894},
     {5.99242, -6.19633, 46.0950},
     0.5,
     0.035},
}};

}  // namespace moraine
