// Steady detonation of an explosive, and what follows it.
#pragma once

#include "exact/flow_state.hpp"
#include "exact/isentrope.hpp"
#include "exact/law.hpp"

namespace moraine {

/// An explosive by its products: `products` with the energy `specific_energy` e_0 that is set free,
/// at the density `density` rho_0 of the solid. The solid itself has pressure zero.
struct Explosive {
  Law products;
  double density = 0.0;          // kg/m^3
  double specific_energy = 0.0;  // J/kg
};

/// The Chapman-Jouguet state, where a self-sustained detonation ends.
struct Detonation {
  double speed;        // m/s, D, into the solid at rest
  FlowState behind;    // of the products, in the frame of the solid
  double sound_speed;  // m/s, of the products there
};

/// The slowest detonation that the jump conditions allow:
///
///   e = e_0 + p (1/rho_0 - 1/rho) / 2,   D^2 = p / (rho_0^2 (1/rho_0 - 1/rho)),   u + c = D
///
/// on the Hugoniot of the products, where the Rayleigh line touches it; Fickett and Davis,
/// Detonation (1979), chapter 2. The least D is sought between 1.005 and 4 rho_0, then u + c = D is
/// bisected. Range: density > 0, p(rho_0, e_0) > 0, a law linear in energy (all of ours are), else
/// std::invalid_argument; std::domain_error unless there is exactly one touching point.
Detonation chapman_jouguet(Explosive const& explosive);

/// Plane detonation that starts at a rigid wall (or plane of symmetry) x = 0 at t = 0 and runs
/// towards +x: C-J state at x = D t, behind it a rarefaction to rest, then products at rest.
///
///   u + c = x/t,   u = u_CJ - w   (w: Isentrope)
///
/// Source: Taylor, Proc. R. Soc. Lond. A 200 (1950) 235; Zel'dovich and Kompaneets, Theory of
/// Detonation (1960), section 12. Range: as chapman_jouguet; std::domain_error if the rarefaction
/// would steepen or the products do not come to rest.
class TaylorWave {
 public:
  explicit TaylorWave(Explosive explosive);

  Detonation const& detonation() const { return detonation_; }
  /// The products at rest between the wall and x = rest_speed() t.
  FlowState const& rest() const { return rest_; }
  /// Speed of the edge of the zone at rest, the sound speed there [m/s].
  double rest_speed() const { return rest_speed_; }
  /// The state on the ray x/t >= 0; at the front that of the C-J state; beyond, the solid: pressure
  /// zero, and the energy that it will set free.
  FlowState sample(double x_over_t) const;

 private:
  Explosive explosive_;
  Detonation detonation_;
  Isentrope isentrope_;
  FlowState rest_;
  double rest_speed_ = 0.0;
};

}  // namespace moraine
