// A damped oscillator on moving ground, stepped exactly.
#pragma once

#include <array>

namespace moraine {

/// Displacement and velocity of the mass against the ground.
struct OscillatorState {
  double displacement = 0.0;  // m
  double velocity = 0.0;      // m/s
};

/// A mass on a spring and a dashpot on ground with the acceleration a:
///
///   u'' + 2 zeta w u' + w^2 u = -a(t)
///
/// solved exactly for an a that runs straight from value to value, whatever the step: the
/// recurrence of Nigam & Jennings, Bull. Seism. Soc. Am. 59 (1969) 909, written
/// with the exponential of the matrix M = [0 1; -w^2 -2 zeta w] and its integrals
///   y_1 = exp(M dt) y_0 + dt (phi_1 - phi_2) b a_0 + dt phi_2 b a_1,  b = (0, -1),
///   phi_1 = (exp(M dt) - 1) / (M dt),  phi_2 = (phi_1 - 1) / (M dt),
/// which are summed as power series where w dt < 1/2, so that no digits cancel.
///
/// Range: w and dt positive, 0 <= zeta < 1; otherwise the constructor throws
/// std::invalid_argument.
class Oscillator {
 public:
  /// Angular frequency w [rad/s], damping ratio zeta [-], time step dt [s].
  Oscillator(double angular_frequency, double damping_ratio, double time_step);

  /// The state a step later, with the acceleration of the ground before and after [m/s^2].
  OscillatorState advance(OscillatorState const& state, double before, double after) const {
    return {phi_[0] * state.displacement + phi_[1] * state.velocity + before_[0] * before +
                after_[0] * after,
            phi_[2] * state.displacement + phi_[3] * state.velocity + before_[1] * before +
                after_[1] * after};
  }

  /// Of the mass in space, u'' + a [m/s^2].
  double absolute_acceleration(OscillatorState const& state) const {
    return -friction_ * state.velocity - stiffness_ * state.displacement;
  }

  /// Of the mass against the ground, u'' [m/s^2].
  double relative_acceleration(OscillatorState const& state, double ground) const {
    return absolute_acceleration(state) - ground;
  }

 private:
  double friction_;   // 1/s, 2 zeta w
  double stiffness_;  // 1/s^2, w^2
  std::array<double, 4> phi_{};
  std::array<double, 2> before_{}, after_{};
};

}  // namespace moraine
