// Charges under ground: pressure waves in soil.
#pragma once

#include <span>
#include <string_view>

namespace moraine::blast {

/// Soil that carries the wave of a buried charge.
struct Soil {
  std::string_view name;
  double k;  // psi at 1 ft/lb^(1/3): the stiffness of the soil as a carrier of pressure
  bool doubtful;
  std::string_view note;
};

/// Closed list. Source: C. W. Lampson, Explosions in earth, NDRC (1946), as in a 2017 doctoral
/// thesis on explosions in granular soil with SPH, chapter 3.
std::span<Soil const> soils();
Soil const* find_soil(std::string_view name);

/// What the relations below share: W [kg of TNT], R [m] from the charge, explosive factor E (on
/// pressure and impulse; 1 for TNT), coupling f of the charge's depth: 1 where H/W^(1/3) is at
/// least 2 ft/lb^(1/3), and below it a number of at most 1 that must be known.
struct BuriedCharge {
  double mass;
  double distance;
  double soil_k;  // psi
  double explosive_factor;
  double coupling;
};

inline constexpr double full_coupling_depth = 2.0;  // ft/lb^(1/3)

/// Peak pressure in the soil [Pa]: p = E f k Z^-3 psi, Z in ft/lb^(1/3).
/// Source: as above. Range: Z of 2 to 15.
double buried_pressure(BuriedCharge const& charge);

/// Impulse per area [Pa s]: I = 0.076 E k^(1/2) f W^(1/3) Z^(-5/2) psi s, W in lb. The impulse on a
/// fixed target is 3 times that. Source and range: as above.
double buried_impulse(BuriedCharge const& charge);
inline constexpr double fixed_target_factor = 3.0;

/// Duration of the positive and of the negative phase [s]:
///   t+ = 0.174 k^(-1/2) R^(1/2) W^(1/6), t- = 0.368 k^(-1/2) R^(1/2) W^(1/6), R in ft, W in lb
/// The powers are those that make 2 I/p grow likewise; the source prints R^2.5 W^(1/5), which gives
/// a hundred times the 2 I/p. Source and range: as above.
double buried_positive_duration(BuriedCharge const& charge);
double buried_negative_duration(BuriedCharge const& charge);

}  // namespace moraine::blast
