// Sedov's blast wave.
#pragma once

#include "exact/flow_geometry.hpp"
#include "exact/flow_state.hpp"

namespace moraine {

/// What a blast starts from.
struct SedovBlast {
  FlowGeometry geometry = FlowGeometry::spherical;
  double heat_capacity_ratio = 1.4;  // -
  double density = 1.0;              // kg/m^3, of the gas ahead
  /// At t = 0 in the origin: J; J/m in cylindrical geometry; in planar geometry J/m^2 for each of
  /// the two sides of the plane.
  double energy = 0.851072;
};

/// Strong blast wave of energy that is released in a point, on a line or on a plane, into cold
/// ideal gas of even density.
///
/// Source: Kamm and Timmes, On Efficient Generation of Numerically Robust Sedov Solutions,
/// LA-UR-07-2849 (2007), the standard case with density exponent omega = 0; after Sedov, Similarity
/// and Dimensional Methods in Mechanics (1959), chapter IV. With the similarity variable V between
/// V_0 = 2/((j+2) gamma) in the origin and V_2 = 4/((j+2)(gamma+1)) at the shock, j the dimensions:
///
///   r/r_2 = lambda(V), u/u_2 = f(V), rho/rho_2 = g(V), p/p_2 = h(V)   (products of powers)
///   r_2 = (E / (alpha rho_0))^(1/(j+2)) t^(2/(j+2)),   U = 2 r_2 / ((j+2) t)
///   rho_2 = (gamma+1)/(gamma-1) rho_0,  u_2 = 2U/(gamma+1),  p_2 = 2 rho_0 U^2/(gamma+1)
///
/// alpha is the energy of the profile, by tanh-sinh quadrature. With A the area at r = 1 m:
///
///   alpha = A (2/(j+2))^2 2/(gamma^2 - 1) int_0^1 (g f^2 + h) lambda^(j-1) dlambda
///
/// Departure: the source integrates over V, with a singular end; the values agree.
/// Range: gamma > 1, density and energy > 0, (j-2) gamma < 3j - 2 (the standard case: below 7 for
/// spheres), and |gamma - 2| >= 1e-4, because at 2 two exponents diverge and cancel; otherwise
/// std::invalid_argument.
class Sedov {
 public:
  explicit Sedov(SedovBlast const& blast);

  /// E / (rho_0 r_2^(j+2) / t^2), dimensionless.
  double alpha() const { return alpha_; }
  double shock_position(double time) const;
  double shock_speed(double time) const;
  /// The state just behind the shock.
  FlowState behind_shock(double time) const;
  /// At distance `r` >= 0 and `time` > 0; on the shock, the state behind. In the origin the
  /// specific energy is infinite and the density zero.
  FlowState sample(double r, double time) const;

 private:
  struct Profile {
    double f, g, h;
  };
  // The bases of the powers, as logarithms, for V = V_0 (1 + x_s exp(y)): the shock at x_s is y =
  // 0, the origin y = -infinity.
  struct Logarithms {
    double x1, x2, x3, x4;
  };
  Logarithms logarithms(double y) const;
  double log_lambda(Logarithms const& x) const;
  Profile profile(double lambda) const;
  double profile_energy() const;

  SedovBlast blast_;
  double gamma_;
  double j_;
  double a0_, a1_, a2_, a3_, a4_, a5_;  // exponents of the source
  double alpha_ = 0.0;
};

}  // namespace moraine
