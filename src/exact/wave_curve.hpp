// The waves that can run into a material.
#pragma once

#include "exact/flow_state.hpp"
#include "exact/isentrope.hpp"

namespace moraine {

enum class WaveKind { shock, rarefaction };

/// One nonlinear wave between two uniform states. A shock has head = tail.
struct Wave {
  WaveKind kind = WaveKind::shock;
  double head = 0.0;  // m/s, of the edge towards the undisturbed material
  double tail = 0.0;  // m/s, of the other edge
  FlowState behind;   // at and behind the tail
};

/// All waves that run towards +x into a uniform material at rest, by the pressure behind them:
/// shocks above the pressure ahead, rarefactions along the isentrope below. Velocities count from
/// that of the material ahead.
/// Source: Menikoff and Plohr, Rev. Mod. Phys. 61 (1989) 75, section II; for shocks hugoniot.hpp,
/// for rarefactions isentrope.hpp. Range: laws whose isentropes spread (Isentrope::spreads) and
/// whose shocks compress; otherwise composite waves would be needed: std::domain_error.
class WaveCurve {
 public:
  /// Throws std::invalid_argument without positive density and sound speed.
  WaveCurve(Law law, double density, double specific_energy);

  FlowState const& ahead() const { return ahead_; }
  Isentrope const& isentrope() const { return isentrope_; }

  /// Velocity behind the wave with this pressure behind it [m/s], negative for rarefactions.
  double velocity(double pressure) const;

  /// The whole wave; pressures below that of the isentrope's end count as that.
  Wave wave(double pressure) const;

  /// The state inside a rarefaction on the ray x/t = `speed` [m/s], between tail and head.
  FlowState inside(double speed) const;

 private:
  IsentropeState expanded(double pressure) const;

  Law law_;
  Isentrope isentrope_;
  FlowState ahead_;
};

/// The same wave running towards -x, in a frame in which the material ahead has `velocity`; or, if
/// `mirror` is false, towards +x.
Wave in_frame(Wave wave, double velocity, bool mirror);

}  // namespace moraine
