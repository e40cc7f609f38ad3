// How far the ground moves beside a buried charge.
#pragma once

#include <span>
#include <string_view>

namespace moraine::blast {

/// Ground whose lasting displacement was measured; in/lb^(1/3) at 1 ft/lb^(1/3).
struct DisplacedGround {
  std::string_view name;
  double horizontal;
  double vertical;
};

/// Closed list: clay, chalk, sand. Source: C. W. Lampson (1946) as in a 2017 doctoral thesis on
/// explosions in granular soil with SPH, chapter 3, whose list of vertical numbers swaps clay and
/// chalk.
std::span<DisplacedGround const> displaced_grounds();
DisplacedGround const* find_displaced_ground(std::string_view name);

/// Range of all of these in R/W^(1/3) [ft/lb^(1/3)]: no displacement beyond 10; the lower end is
/// that of the pressures of the same source.
inline constexpr double least_displacement_distance = 2.0;
inline constexpr double most_displacement_distance = 10.0;

/// Lasting displacement [m]: U/W^(1/3) = C Z^-4 in/lb^(1/3), Z in ft/lb^(1/3); `c` is `horizontal`
/// or `vertical` of the ground. W [kg of TNT], R [m].
double permanent_displacement(double charge_mass, double distance, double c);

/// Largest passing displacement in medium sand [m], per W^(1/3) [in/lb^(1/3)]:
///   horizontal 47.3 Z^-3 + 0.216 Z^-1, vertical 12.6 Z^-3 + 0.032 Z^-1
/// Source: the thesis as above.
double transient_horizontal_displacement(double charge_mass, double distance);
double transient_vertical_displacement(double charge_mass, double distance);

}  // namespace moraine::blast
