// What particles answer that remember how far they have been compacted.
#pragma once

#include <cstddef>
#include <span>

#include "matter/eos/state_response.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// Pressure and sound speed of material that may be compacted; notes how far it is by then.
///
/// The states asked for are those predicted to the new time with the rates of the last. They are
/// what particles pass through as far as forces are concerned: the pressure of this very state
/// drives the step and does the work that is booked. Were pores crushed by the corrected density
/// instead, forces would follow one path and the memory another, and a cycle could gain what lies
/// between the two. Prediction and correction differ by the square of the step; where a case begins
/// anew from its last state, the prediction is that state, and asking again changes nothing.
///
/// The sound speed is that of unloading, also while pores are crushed and loading is slower. It is
/// the fastest signal that the particle can send in the next step, which the length of the step
/// must allow for; and viscosity that knew the slower speed alone would let the front of a wave
/// ring, and each swing crushes pores for good (verify/exact/compaction).
template <class Law>
auto compacting(Law const& law, ParticleStore& store) {
  return [&law, distension = store.scalar(Field::distension)](std::size_t i, double rho, double e) {
    auto const response = law.respond(rho, e, distension[i]);
    distension[i] = response.distension;
    return StateResponse{response.pressure, signed_root(response.unloading_speed_squared)};
  };
}

}  // namespace moraine
