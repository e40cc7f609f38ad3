// Craters, broken ground and closed cavities.
#pragma once

#include <span>
#include <string_view>

namespace moraine::blast {

/// Diameter of the crater of a charge on the ground [m]: D = c W^(1/3), W [kg of TNT].
double crater_diameter(double charge_mass, double c);
/// G. F. Kinney, K. J. Graham, Explosive Shocks in Air, 2nd ed. (1985): c = 0.8, within 30 %.
inline constexpr double kinney_graham_crater = 0.8;  // m/kg^(1/3)
/// D. Ambrosini et al., Size of craters produced by explosive charges on or above the ground
/// surface, Shock Waves 12 (2002) 69: a spherical charge that rests on soil, c = 0.51, within 5 %.
inline constexpr double ambrosini_crater = 0.51;
/// A hemispherical charge at ground level: c about 0.65; source not verified.
inline constexpr double hemispherical_crater = 0.65;

/// Diameter of the crater of a buried charge [m]: D = 2.6 f k^n W^(1/3) ft, W in lb, k of the soil
/// in psi (buried.hpp), f a factor of the depth, n = 0.05. Source: C. W. Lampson (1946) as in a
/// 2017 doctoral thesis on explosions in granular soil with SPH, chapter 3. Doubtful: it prints n =
/// 0.5, by which 1 lb would leave 184 ft.
double lampson_crater_diameter(double charge_mass, double soil_k, double depth_factor);

/// Volume of the closed cavity of a deep charge in clay [m^3]: 10 ft^3/lb. Source: the thesis.
double camouflet_volume(double charge_mass);

/// Ground and the radius to which a charge breaks it, in ft/lb^(1/3), least and most.
struct BrokenGround {
  std::string_view name;
  double low;
  double high;
};

/// Closed list. Source: the thesis, chapter 3.
std::span<BrokenGround const> broken_grounds();
BrokenGround const* find_broken_ground(std::string_view name);

/// Rupture radius [m]: R = F W^(1/3) ft, W in lb; F of a BrokenGround.
double rupture_radius(double charge_mass, double f);

/// What a charge at a depth leaves: a scour by a charge that sticks out of the ground, a crater
/// thrown out by a covered charge, or a closed cavity (camouflet).
enum class CraterType { scour, throw_out, camouflet };

/// `depth` [m] from the ground to the centre of the charge: a scour above its radius, a camouflet
/// where the rupture radius does not reach the surface. The source names three types by depth but
/// prints no limits; these are the program's reading.
CraterType crater_type(double charge_mass, double depth, double rupture_factor);

/// Radius of a sphere of cast TNT, 1630 kg/m^3 [m].
double charge_radius(double charge_mass);

}  // namespace moraine::blast
