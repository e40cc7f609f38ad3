// Air blast of hemispherical TNT charges on the ground: simpler polynomials for the same data.
#pragma once

#include "blast/kingery_bulmash.hpp"

namespace moraine::blast {

/// Simplified polynomials for hemispherical surface bursts at sea level:
///   Y = exp(sum_i c_i (ln Z)^i)
/// Source: M. M. Swisdak, Simplified Kingery airblast calculations, 26th DoD Explosives Safety
/// Seminar (1994), metric. Z [m/kg^(1/3)] and units as of kingery_bulmash.hpp.
/// Range: swisdak_range and the others; outside it the nearest piece goes on and means nothing.
double swisdak_overpressure(double scaled_distance);            // Pa
double swisdak_reflected_overpressure(double scaled_distance);  // Pa
double swisdak_arrival_time(double scaled_distance);            // s/kg^(1/3)
double swisdak_duration(double scaled_distance);                // s/kg^(1/3)
double swisdak_impulse(double scaled_distance);                 // Pa s/kg^(1/3)
double swisdak_reflected_impulse(double scaled_distance);       // Pa s/kg^(1/3)
double swisdak_front_speed(double scaled_distance);             // m/s

inline constexpr ScaledRange swisdak_overpressure_range{0.2, 198.5};  // m/kg^(1/3)
inline constexpr ScaledRange swisdak_impulse_range{0.2, 158.7};
inline constexpr ScaledRange swisdak_duration_range{0.2, 40.0};
inline constexpr ScaledRange swisdak_range{0.06, 40.0};  // all others

}  // namespace moraine::blast
