// How a deviatoric stress goes on in time: turned with the material, strained, held to its yield
// surface.
#pragma once

#include <cmath>

#include "base/tensor.hpp"
#include "matter/strength/deviator.hpp"

namespace moraine {

/// What a material point goes through in a time dt.
struct Deformation {
  Symmetric<3> strain{};         // eps_rate dt: symmetric part of the velocity gradient [-]
  std::array<double, 3> turn{};  // rotation vector of its skew part, times dt [rad]
};

/// Of a velocity gradient L_ab = d v_a / d x_b of D x D numbers, row by row [1/s]; plane strain in
/// 2D, uniaxial strain in 1D.
template <int D, class Gradient>
MORAINE_HD Deformation deformation(Gradient const& gradient, double dt) {
  auto const entry = [&](int a, int b) { return a < D && b < D ? dt * gradient(a * D + b) : 0.0; };
  auto const even = [&](int a, int b) { return 0.5 * (entry(a, b) + entry(b, a)); };
  auto const odd = [&](int a, int b) { return 0.5 * (entry(a, b) - entry(b, a)); };
  return {{even(0, 0), even(1, 1), even(2, 2), even(0, 1), even(0, 2), even(1, 2)},
          {odd(2, 1), odd(0, 2), odd(1, 0)}};
}

/// Elastic stress after a deformation, by the rate of Jaumann,
///
///   ds/dt = 2 G (eps_rate - tr(eps_rate)/3 1) + Omega s - s Omega,
///
/// G shear modulus [Pa], Omega the skew part of the velocity gradient. Half of the rotation comes
/// before the strain and half after it: second order in dt, and exact for a rotation without
/// strain, however far. Source: Jaumann (1911), as in Libersky et al., J. Comput. Phys. 109 (1993)
/// 67, whose equation has the factor 2 that some later texts lose.
MORAINE_HD inline Deviator elastic_stress(Deviator const& s, double shear_modulus,
                                          Deformation const& d) {
  Matrix3 const half = rotation({0.5 * d.turn[0], 0.5 * d.turn[1], 0.5 * d.turn[2]});
  Deviator stress = turned(s, half);
  double const volume = (d.strain[0] + d.strain[1] + d.strain[2]) / 3.0;
  for (std::size_t k = 0; k < 6; ++k)
    stress[k] += 2.0 * shear_modulus * (d.strain[k] - (k < 3 ? volume : 0.0));
  return turned(stress, half);
}

/// Stress and what yielding has done.
struct StressState {
  Deviator stress{};            // Pa
  double plastic_strain = 0.0;  // sum of sqrt(2/3 d eps_p : d eps_p) [-]
  double plastic_work = 0.0;    // s : d eps_p, per volume [J/m^3]
};

/// A stress after a deformation at the pressure `p` [Pa], for a law of
/// matter/strength/strength.hpp: the elastic one, then law.limit. What the limit takes away is
/// plastic strain,
///
///   d eps_p = (s_elastic - s) / (2 G),
///
/// without change of volume.
template <class Law>
MORAINE_HD StressState advance_stress(Law const& law, StressState const& before,
                                      Deformation const& d, double p) {
  double const g = law.shear_modulus;
  Deviator const elastic = elastic_stress(before.stress, g, d);
  StressState after = before;
  after.stress = law.limit(elastic, p);
  if (!(g > 0.0)) return after;
  Symmetric<3> plastic{};
  for (std::size_t k = 0; k < 6; ++k) plastic[k] = 0.5 * (elastic[k] - after.stress[k]) / g;
  after.plastic_strain += std::sqrt(2.0 / 3.0 * contraction(plastic, plastic));
  after.plastic_work += contraction(after.stress, plastic);
  return after;
}

}  // namespace moraine
