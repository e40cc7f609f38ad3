// Programmed burn: an explosive that turns into products behind a front of given speed.
#pragma once

#include <algorithm>

#include "base/macros.hpp"
#include "matter/eos/state_response.hpp"

namespace moraine {

/// Programmed burn. The burn fraction F of a particle is
///
///   F = min(1, max(0, (t - t_lit) D / w, (1 - rho_0 / rho) / (1 - V_cj)))
///
///   p = F p_products(rho, e)
///
/// Source: Giroux, HEMP User's Manual, UCRL-51079 (1973): the larger of a front of speed D that is
/// spread over a few spacings and of burning by compression.
/// Symbols: t_lit lighting time of the particle, D detonation_velocity, w width, V_cj cj_volume.
/// Once a particle is lit, or all burnt, its F never falls. Before, burning by compression goes
/// back where the compression does: what only leans on an explosive must not light it bit by bit.
/// Where it never falls, as in Giroux, water at 176 kPa beside a charge does
/// (docs/theory/matter.md). The particle carries the energy of the explosive from the start:
/// burning releases pressure and no energy, so there is nothing to book.
struct ProgrammedBurn {
  double detonation_velocity = 0.0;  // m/s
  double cj_volume = 0.0;            // rho_0 / rho of the Chapman-Jouguet state, in ]0, 1[
  double width = 0.0;                // m, of the front
  double reference_density = 0.0;    // kg/m^3, rho_0 of the explosive

  /// Fraction to which compression alone burns; negative in expansion.
  MORAINE_HD double by_compression(double rho) const {
    return (1.0 - reference_density / rho) / (1.0 - cj_volume);
  }

  /// Burn fraction after `before`, at density `rho` [kg/m^3] and `lit_for` [s] after the lighting
  /// time (negative before it, -infinity for what is not lit at all).
  MORAINE_HD double fraction(double before, double rho, double lit_for) const {
    double const kept = lit_for >= 0.0 || before >= 1.0 ? before : 0.0;
    double const front = lit_for * detonation_velocity / width;
    return std::min(1.0, std::max(kept, std::max(front, by_compression(rho))));
  }

  /// Pressure and sound speed of explosive of which `fraction` has burnt, by the fraction's own
  /// derivative along an adiabat:
  ///
  ///   c^2 = F (c_p^2 - (1 - F) (p_p / rho^2) dp_p/de)
  ///       + p_p (rho_0 / rho^2) / (1 - V_cj)   where compression decides F, and F < 1
  ///
  /// with p_p and c_p of the products. Explosive that has not begun to burn and is not compressed
  /// has p = 0 and c = 0; at rho_0 it is as stiff as the burning by compression makes it.
  template <class Products>
  MORAINE_HD StateResponse respond(Products const& products, double rho, double e,
                                   double fraction) const {
    StateResponse const burnt = products.respond(rho, e);
    if (!(fraction < 1.0)) return burnt;
    double const c = burnt.sound_speed;
    double const heating = burnt.pressure / (rho * rho) * products.pressure_by_energy(rho);
    double c2 = fraction * (c * (c < 0.0 ? -c : c) - (1.0 - fraction) * heating);
    if (by_compression(rho) >= fraction)
      c2 += burnt.pressure * reference_density / (rho * rho * (1.0 - cj_volume));
    return {fraction * burnt.pressure, signed_root(c2)};
  }
};

}  // namespace moraine
