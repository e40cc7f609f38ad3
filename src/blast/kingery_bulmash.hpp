// Air blast of TNT: the polynomials of Kingery and Bulmash.
#pragma once

#include "blast/scales.hpp"

namespace moraine::blast {

/// Where the charge lies: a sphere far from any surface, or a hemisphere on rigid ground.
enum class Burst { free_air, surface };

/// Range of the polynomials of one quantity in scaled distance [m/kg^(1/3)].
struct ScaledRange {
  double low;
  double high;
};

/// Polynomials of Kingery and Bulmash for TNT at sea level:
///   log10 Y = sum_i c_i U^i,  U = U_0 + U_1 log10 Z
/// Source: C. N. Kingery, G. Bulmash, Airblast parameters from TNT spherical air burst and
/// hemispherical surface burst, ARBRL-TR-02555 (1984); coefficients in imperial units as in
/// G. Randers-Pehrson, K. Bannister, Airblast loading model for DYNA2D and DYNA3D, ARL-TR-1310
/// (1997).
/// Z = R/W^(1/3) [m/kg^(1/3)] with R [m] from the centre of the charge and W [kg of TNT].
/// Values that scale with the charge are per kg^(1/3).
///
/// Range: the functions below. Outside it they go on with the nearest polynomial,
/// whose values mean nothing there: callers must ask for the range.
double kingery_overpressure(Burst burst, double scaled_distance);            // Pa
double kingery_reflected_overpressure(Burst burst, double scaled_distance);  // Pa
double kingery_arrival_time(Burst burst, double scaled_distance);            // s/kg^(1/3)
double kingery_duration(Burst burst, double scaled_distance);                // s/kg^(1/3)
double kingery_impulse(Burst burst, double scaled_distance);                 // Pa s/kg^(1/3)
double kingery_reflected_impulse(Burst burst, double scaled_distance);       // Pa s/kg^(1/3)

/// 0.134 to 100 ft/lb^(1/3) in free air, 0.17 to 100 at the surface.
constexpr ScaledRange kingery_range(Burst burst) {
  return {(burst == Burst::free_air ? 0.134 : 0.17) * foot_per_pound, 100.0 * foot_per_pound};
}
/// 0.37 to 100 ft/lb^(1/3) in free air, 0.45 to 100 at the surface.
constexpr ScaledRange kingery_duration_range(Burst burst) {
  return {(burst == Burst::free_air ? 0.37 : 0.45) * foot_per_pound, 100.0 * foot_per_pound};
}

}  // namespace moraine::blast
