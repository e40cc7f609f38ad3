// Reflection of a plane front at a rigid wall that it meets at an angle.
#pragma once

#include <optional>

namespace moraine::blast {

/// Regular reflection of a front of overpressure p at the angle alpha between front and wall
/// [rad, 0 head-on]: overpressure at the wall [Pa], or nothing where the theory has no solution and
/// a Mach stem forms.
///
/// Two-shock theory (von Neumann 1943): seen from the point where the front meets the wall, the
/// incident front turns the stream towards the wall and the reflected one, the weaker of two that
/// can, turns it back. Ideal gas, gamma = 1.4. At alpha = 0 this is normal_reflection. Throws
/// nothing; p > 0, 0 <= alpha < pi/2.
std::optional<double> regular_reflection(double overpressure, double ambient_pressure,
                                         double angle);

/// Largest angle of regular reflection [rad], where the reflected front detaches: near pi/2 for
/// weak fronts, 39.97 degrees for very strong ones.
double extreme_angle(double overpressure, double ambient_pressure);

/// A Mach stem that grows along the wall.
struct MachStem {
  double overpressure;  // Pa, behind the stem
  double path_angle;    // rad, between the wall and the path of the triple point
};

/// Mach reflection at a plane wall, overpressure and angle as above, or nothing where the theory
/// has no solution.
///
/// Three-shock theory (von Neumann 1943): the incident front, the reflected one and the stem meet
/// in a point; behind the latter two pressure and direction of the stream are the same. The stem is
/// taken as straight and normal to the wall. Strong fronts only: weak ones (p/p_a below about 1)
/// reflect with a stem although there is no solution (von Neumann's paradox). The curvature of a
/// blast wave and of the stem is neglected.
std::optional<MachStem> mach_reflection(double overpressure, double ambient_pressure, double angle);

}  // namespace moraine::blast
