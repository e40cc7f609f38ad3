// The state of a flow at one place and time.
#pragma once

namespace moraine {

/// What exact solutions of compressible flow answer. In a vacuum all are zero.
struct FlowState {
  double density = 0.0;          // kg/m^3
  double velocity = 0.0;         // m/s, positive towards larger x or r
  double pressure = 0.0;         // Pa, positive in compression
  double specific_energy = 0.0;  // J/kg, internal
};

/// The same flow seen in a mirror: x and velocities change their sign.
inline FlowState mirrored(FlowState state) {
  state.velocity = -state.velocity;
  return state;
}

}  // namespace moraine
