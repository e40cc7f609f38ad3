// Records at another step of time.
#pragma once

#include "records/ground_record.hpp"

namespace moraine {

/// What is taken to be between the values: the smoothest wave that holds no frequency above half of
/// one over the step, or straight lines.
enum class Interpolation { band_limited, linear };

/// The record at the step `time_step` [s], from the same first time to the last that fits.
///
/// band_limited: the sum over the values times sinc(2 f_c (t - t_i)) under a Kaiser window (beta
/// 10, 32 zero crossings to each side), with weights that sum to one. f_c is half of one over the
/// old step for finer steps, so that old values stay; for coarser ones 0.9 times half of one over
/// the time step, so that what the new step cannot hold is left out: waves up to 0.8 of that half
/// keep their amplitude within 1e-4, those above it fall below 1e-4. Source: Oppenheim & Schafer,
/// Discrete-Time Signal Processing (1999), sections 4.6 and 7.4.
/// linear: for finer steps only.
/// Throws std::invalid_argument for a bad record or step, for fewer than two values, and for
/// coarser steps by straight lines.
GroundRecord resampled(GroundRecord const& record, double time_step, Interpolation interpolation);

}  // namespace moraine
