// A solid that is compressed along one axis, as a law for shocks.
#pragma once

#include <cmath>

#include "matter/eos/eos.hpp"
#include "matter/strength/strength.hpp"

namespace moraine {

/// Axial stress of a solid under monotone compression along x from rho_0 without stress:
///
///   P(rho, e) = p(rho, e) - s_xx,   s_xx = limit(-4/3 G ln(rho / rho_0))
///
/// The rate of Jaumann, dsxx/dt = 4/3 G d eps/dt, integrates to the logarithm; what the material
/// does not bear of it is cut at the pressure of the same state. With P in place of the
/// pressure the jump conditions of exact/hugoniot.hpp are those of plane shocks in solids, without
/// the precursor of those that yield. Source: Davison, Fundamentals of Shock Wave Propagation in
/// Solids (2008), chapter 8.
struct UniaxialSolid {
  Eos eos;
  Strength strength;

  /// -s_xx at density rho and pressure p [Pa].
  double axial_shear(double rho, double p) const {
    return std::visit(
        [&](auto const& law) {
          if constexpr (requires { law.shear_modulus; }) {
            double const s =
                -4.0 / 3.0 * law.shear_modulus * std::log(rho / reference_density(eos));
            return -law.limit(unpacked<1>({s}), p)[0];
          } else {
            return 0.0;
          }
        },
        strength);
  }

  /// P [Pa].
  double pressure(double rho, double e) const {
    double const p = std::visit([&](auto const& law) { return law.pressure(rho, e); }, eos);
    return p + axial_shear(rho, p);
  }

  /// dP/drho + (P / rho^2) dP/de, by differences: laws of strength have corners.
  double sound_speed_squared(double rho, double e) const {
    double const d = 1e-6 * rho;
    double const heat = 1e-6 * (std::fabs(e) + 1.0);
    double const by_density = (pressure(rho + d, e) - pressure(rho, e)) / d;
    double const by_energy = (pressure(rho, e + heat) - pressure(rho, e)) / heat;
    return by_density + pressure(rho, e) / (rho * rho) * by_energy;
  }
};

}  // namespace moraine
