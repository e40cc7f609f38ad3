// Shocks of charges in water.
#pragma once

namespace moraine::blast {

/// Peak pressure in water [Pa] at R/W^(1/3) [m/kg^(1/3)], TNT. With X = W^(1/3)/R in lb^(1/3)/ft
/// or, where marked SI, in kg^(1/3)/m:
///   Penney:             14100 X e^(0.27 X) psi
///   Kirkwood-Brinkley:  22150 X (log10(1/X) + 0.873)^(-1/2) psi, 1/X > 13
///   Cole:               52.4e6 X^1.13 Pa (SI)
/// Sources: R. H. Cole, Underwater Explosions (1948), chapters 4 and 7, as in a 2017 doctoral
/// thesis on explosions in granular soil with SPH, chapter 3.
double penney_pressure(double scaled_distance);
double kirkwood_brinkley_pressure(double scaled_distance);
double cole_pressure(double scaled_distance);

/// Impulse per area [Pa s/kg^(1/3)]: I = 2.11 W^(2/3)/R lbf s/in^2, W in lb, R in ft. Source: the
/// thesis as above.
double inverse_distance_water_impulse(double scaled_distance);

/// Similitude equations for TNT, X = W^(1/3)/R in kg^(1/3)/m:
///   p = 52.16e6 X^1.13 Pa, theta = 96.5e-6 W^(1/3) X^-0.22 s, I = 5750 W^(1/3) X^0.89 Pa s,
///   E = 84 400 W^(1/3) X^2.04 J/m^2
/// theta is the time in which the pressure falls by e, I and E the impulse and energy per area. Per
/// kg^(1/3) below. Source: M. M. Swisdak, Explosion effects and properties, part II, NSWC/WOL
/// TR 76-116 (1978), for peaks of 3.4 to 138 MPa.
double swisdak_water_pressure(double scaled_distance);
double swisdak_water_time_constant(double scaled_distance);
double swisdak_water_impulse(double scaled_distance);
double swisdak_water_energy(double scaled_distance);

/// Peak pressure [Pa]: 44.1e6 X^1.5 for 6 <= R/R_0 < 12, 52.4e6 X^1.13 for 12 <= R/R_0 < 240, and
/// time constant [s/kg^(1/3)]: 0.45e-3 R_0 r^0.45 for r = R/R_0 below 30, 3.5 (R_0/c)
/// sqrt(log10 r - 0.9) beyond; R_0 the radius of a sphere of 1630 kg/m^3 [m], c = 1500 m/s.
/// Source: B. V. Zamyshlyaev, Yu. S. Yakovlev, Dynamic loads in underwater explosion (1967).
/// Outside the nearest piece goes on.
double zamyshlyaev_pressure(double scaled_distance);
double zamyshlyaev_time_constant(double scaled_distance);
double charge_radii(double scaled_distance);  // R/R_0

/// Share of the energy of the shock that the water has turned to heat on the way: 0.30 at 5 charge
/// radii and 0.48 at 25. Between them linear in log(R/R_0), beyond them the nearer number. Source:
/// the thesis as above, which gives these two numbers.
double energy_lost(double scaled_distance);

}  // namespace moraine::blast
