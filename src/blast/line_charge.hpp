// Long charges, whose blast is cylindrical: what plane-strain runs are to be set beside.
#pragma once

namespace moraine::blast {

/// Scaled distance of a line charge, R sqrt(L/W) [m/sqrt(kg/m)]: the overpressure beside it is a
/// function of this number. R [m] from the axis, W [kg], L its length [m].
double line_scaled_distance(double charge_mass, double length, double distance);

/// Geometry of an energy release: plane, line or point.
enum class Source { plane = 1, line = 2, point = 3 };

/// Sachs length [m], R_0 = (E/(p_a L^(3-theta)))^(1/theta) with theta = 1, 2, 3 for a plane, line
/// and point source; E [J] in all, L [m] the extent of the charge in the 3 - theta directions along
/// it.
double sachs_length(Source source, double energy, double length, double ambient_pressure);

/// Largest R/R_0 of line_source_overpressure.
inline constexpr double most_line_ratio = 760.0;

/// Overpressure over ambient pressure of an ideal line source at R/R_0, R_0 the Sachs length of a
/// line: energy released at once, without mass, in an ideal gas with gamma = 1.4.
///
/// Source: S. Hancock, Blast::IPS (finite differences and characteristics, stated error 5e-7); 13
/// rows of his table C1.4, with slopes, are interpolated by cubic Hermite polynomials of the
/// logarithms, within 0.02 % of the others. Below the table the strong blast of Sedov goes on,
/// above it the last slope, -0.759, close to the -3/4 of a weak cylindrical shock. Range: R/R_0 <=
/// 760. A charge has a mass: near it, where the swept air is not far heavier, the ideal source
/// means nothing.
double line_source_overpressure(double distance_over_sachs_length);

}  // namespace moraine::blast
