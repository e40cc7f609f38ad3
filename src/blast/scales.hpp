// Units in which the sources of the relations print their numbers, in SI.
#pragma once

namespace moraine::blast {

inline constexpr double pound = 0.45359237;                          // kg, exact
inline constexpr double foot = 0.3048;                               // m, exact
inline constexpr double inch = 0.0254;                               // m, exact
inline constexpr double pound_force = 4.4482216152605;               // N, exact
inline constexpr double psi = pound_force / (inch * inch);           // Pa
inline constexpr double bar = 1e5;                                   // Pa
inline constexpr double kilopond_per_cm2 = 98066.5;                  // Pa, kgf/cm^2, exact
inline constexpr double cube_root_of_pound = 0.7683431908470758;     // kg^(1/3), of 0.45359237 kg
inline constexpr double foot_per_pound = foot / cube_root_of_pound;  // m/kg^(1/3), of ft/lb^(1/3)

/// Air at sea level: ICAO standard atmosphere (Doc 7488), 15 degrees Celsius.
inline constexpr double standard_pressure = 101325.0;  // Pa
inline constexpr double standard_density = 1.225;      // kg/m^3

/// Heat capacity ratio of air as an ideal gas.
inline constexpr double heat_capacity_ratio = 1.4;

/// Energy that TNT releases [J/kg]: 4610 J/g, a 2017 doctoral thesis on explosions in granular soil
/// with SPH, chapter 3.
inline constexpr double tnt_energy = 4.61e6;

/// Density of cast TNT [kg/m^3], for the radius of a charge; the reference density of the shipped
/// material.
inline constexpr double tnt_density = 1630.0;

}  // namespace moraine::blast
