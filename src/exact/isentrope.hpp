// Expansion of a material at constant entropy.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "exact/law.hpp"

namespace moraine {

/// One state of an isentrope.
struct IsentropeState {
  double density;          // kg/m^3
  double specific_energy;  // J/kg
  double pressure;         // Pa
  double sound_speed;      // m/s
  double velocity_change;  // m/s, integral of c d(rho)/rho from here to the start
};

/// How an isentrope ends on the side of small densities.
enum class IsentropeEnd {
  vacuum,         // the sound speed vanishes: a gas has escaped
  floor,          // the pressure stays at the least that the law gives: a liquid cavitates
  no_sound_speed  // c^2 is not positive beyond
};

/// States that a material takes when it expands from one state without heat:
///
///   de/drho = p / rho^2,   dw/drho = -c / rho
///
/// w is what a rarefaction wave adds to the velocity; Landau and Lifshitz, Fluid Mechanics, 2nd ed.
/// (1987), section 99.
///
/// Integrated in -ln(rho) by an embedded Runge-Kutta-Fehlberg method of order 8(7) with a relative
/// error of 1e-13 per step, until the sound speed has fallen to 1e-12 of its start; what is left of
/// w is 2 c / (gamma - 1) with gamma = rho c^2 / p there, exact for all laws that become ideal
/// gases. States between steps come from one shorter step and are as exact.
///
/// Throws std::invalid_argument without positive density and sound speed at the start.
class Isentrope {
 public:
  Isentrope(Law law, double density, double specific_energy);

  IsentropeState const& start() const { return states_.front(); }
  /// The last state; of a gas that has escaped, density and pressure are zero.
  IsentropeState const& end() const { return states_.back(); }
  IsentropeEnd ends_by() const { return ends_by_; }

  /// The state on the way down in density where `excess` stops to be positive, which it does once;
  /// the end if it does not.
  IsentropeState where(std::function<double(IsentropeState const&)> const& excess) const;

  /// The state at pressure `p` [Pa], between the pressures of start and end.
  IsentropeState at_pressure(double p) const;

  /// Whether u + c falls all the way down, so that a rarefaction wave spreads and does not steepen:
  /// a positive fundamental derivative, Menikoff and Plohr, Rev. Mod. Phys. 61 (1989) 75.
  bool spreads() const;

 private:
  using Vector = std::array<double, 3>;  // e, w, p over c^2, c and rho c^2 of the start

  void integrate();
  Vector rate(Vector const& y, double s) const;
  Vector stepped(std::size_t knot, double size) const;
  IsentropeState state(Vector const& y, double s) const;
  bool admits(Vector const& y, double s) const;
  void end_at_floor(double size);
  void end_in_vacuum();

  Law law_;
  double density_;
  double sound_speed_;
  std::vector<double> depths_;  // s = -ln(rho / rho at the start), of the knots
  std::vector<Vector> knots_;
  std::vector<IsentropeState> states_;  // of the knots; the last one may be a vacuum without a knot
  IsentropeEnd ends_by_ = IsentropeEnd::vacuum;
};

}  // namespace moraine
