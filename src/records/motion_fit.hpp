// Synthetic motions with wanted measures.
#pragma once

#include "records/synthetic_motion.hpp"

namespace moraine {

/// What a motion shall have.
struct MotionTarget {
  double peak_acceleration = 0.0;   // PGA, m/s^2
  double velocity_ratio = 0.0;      // PGV/PGA, s
  double predominant_period = 0.0;  // s, of the largest pseudo acceleration at 5 % damping
  double duration = 20.0;           // s
  double time_step = 0.005;         // s
  Envelope envelope;
};

/// What it has.
struct FittedMotion {
  GroundRecord record;
  NoiseFilter filter;
  double peak_acceleration = 0.0;   // m/s^2, as wanted but for rounding
  double velocity_ratio = 0.0;      // s
  double predominant_period = 0.0;  // s
  int realisation = 0;              // which sequence of noise of the seed, from 1

  /// The larger of the relative errors of PGV/PGA and of the predominant period [-].
  double error(MotionTarget const& target) const;
};

/// The motion nearest to the target. For a sequence of noise, and a layer, the corner frequency is
/// found by halving so that PGV/PGA is met (a lower corner leaves more velocity); then noise and
/// layer are stretched in time until the predominant period is met too. Where both are not met
/// within `close_enough`, layers of other frequencies and dampings and then the next of up to
/// `realisations` sequences of the same seed are tried, and the best of all is returned: look at
/// `error`. The same seed gives the same bits.
///
/// Range: PGV/PGA of a harmonic motion is T/(2 pi); broad motions reach one to three times that of
/// their predominant period. Throws std::invalid_argument unless all targets are positive, the step
/// is at most a tenth of the period and the duration at least ten periods and below 1e7 steps.
FittedMotion fit_motion(MotionTarget const& target, std::uint64_t seed);

inline constexpr double close_enough = 0.005;
inline constexpr int realisations = 20;

}  // namespace moraine
