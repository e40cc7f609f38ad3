// A plane oblique shock in a steady stream of an ideal gas, in terms of its pressure ratio.
#pragma once

namespace moraine::blast {

/// Relations for gamma = 1.4 between the pressure ratio eta across an oblique shock, the Mach
/// number M of the stream ahead and the deflection theta. Source: Ames Research Staff, Equations,
/// tables, and charts for compressible flow, NACA Report 1135 (1953), eqs. (128) to (168). All take
/// 1 <= eta <= strongest_ratio(M).

/// Square of the Mach number of the stream across the shock: M_n^2 = (6 eta + 1)/7.
double normal_mach_squared(double pressure_ratio);

/// eta of a normal shock: (7 M^2 - 1)/6.
double strongest_ratio(double mach_squared);

/// Angle by which the stream turns [rad]:
///   tan theta = (eta - 1)/(1 + gamma M^2 - eta) sqrt(M^2/M_n^2 - 1)
double deflection(double pressure_ratio, double mach_squared);

/// Square of the Mach number behind: [M^2 (6 eta + 1) - 5 (eta^2 - 1)] / [eta (eta + 6)].
double mach_squared_behind(double pressure_ratio, double mach_squared);

/// eta of the shock that turns the stream most, the end of the weak branch; M > 1.
double detachment_ratio(double mach_squared);

}  // namespace moraine::blast
