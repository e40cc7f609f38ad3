// Butterworth filters for records.
#pragma once

#include "records/ground_record.hpp"

namespace moraine {

/// What a filter keeps.
enum class Passband { low, high };

/// Once, as an instrument would; or forward and then backward in time, which doubles the order and
/// moves nothing.
enum class Passes { forward, both_ways };

/// A Butterworth filter: one pass has the gain
///   low:  |H|^2 = 1 / (1 + (tan(pi f dt) / tan(pi f_c dt))^(2 n)),   high: tangents exchanged,
/// so 1/sqrt(2) (-3 dB) at the corner for any order n; both ways |H|^2, a half (-6 dB), without a
/// shift of phase. Source: Oppenheim & Schafer, Discrete-Time Signal Processing (1999), section 7.1
/// (bilinear transform with the corner kept in place).
struct Butterworth {
  Passband passband = Passband::low;
  double corner = 0.0;  // Hz
  int order = 2;        // 1 to 8
  Passes passes = Passes::both_ways;
};

/// The filtered record, of the same length; outside of it the ground is at rest. Throws
/// std::invalid_argument unless corner < 1/(2 dt) and 1 <= order <= 8, and for a corner so low that
/// the filter rings for more than ten million steps (order 2: 6e-7/dt).
GroundRecord filtered(GroundRecord record, Butterworth const& filter);

}  // namespace moraine
