// What another explosive is worth in TNT.
#pragma once

#include <span>
#include <string_view>

namespace moraine::blast {

/// Factors of an explosive: those of the same mass of TNT are 1.
struct Explosive {
  std::string_view name;
  double pressure_factor;  // on pressures and impulses at the same scaled distance
  double mass_factor;      // kg of TNT per kg, before scaling
  std::string_view source;
};

/// Closed list; a factor acts either on pressure and impulse or on the mass.
std::span<Explosive const> explosives();
Explosive const* find_explosive(std::string_view name);

}  // namespace moraine::blast
