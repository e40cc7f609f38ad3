// Ground motions made of filtered noise.
#pragma once

#include <cstdint>
#include <vector>

#include "records/ground_record.hpp"

namespace moraine {

/// A layer of soil on rock, and the corner below which ground does not move: the noise of Kanai and
/// Tajimi under the second filter of Clough and Penzien.
struct NoiseFilter {
  double ground_frequency = 2.5;  // Hz, of the layer
  double ground_damping = 0.6;    // -
  double corner_frequency = 0.2;  // Hz, of the second filter
  double corner_damping = 0.6;    // -
};

/// How strong the shaking is over time: rises as t^2, stays, and falls exponentially to a twentieth
/// at the end. Times are parts of the duration. Jennings, Housner & Tsai, Simulated Earthquake
/// Motions (Caltech, 1968), section 3.
struct Envelope {
  double rise = 0.15;  // ends
  double stay = 0.55;  // ends

  /// The factor at a part of the duration, 0 to 1.
  double at(double part) const;
};

/// White noise: independent normal numbers with mean 0 and variance 1, the same for the same seed
/// on every machine but for the rounding of sin, cos, log and sqrt (Box & Muller, Ann. Math. Stat.
/// 29 (1958) 610, on the 64-bit Mersenne twister).
std::vector<double> white_noise(std::size_t count, std::uint64_t seed);

/// What a motion is made with.
struct NoiseMotion {
  double duration = 20.0;     // s
  double time_step = 0.005;   // s
  double noise_step = 0.005;  // s, between the numbers of the noise, joined by straight lines
  double peak = 1.0;          // m/s^2, largest acceleration
  NoiseFilter filter;
  Envelope envelope;
};

/// A motion: noise through the layer,
///   H_1 = (1 + 2 i z r) / (1 - r^2 + 2 i z r),  r = f / f_g,
/// times the envelope, through the second filter
///   H_2 = r^2 / (1 - r^2 + 2 i z r),  r = f / f_f,
/// which leaves neither velocity nor displacement in the end, and a straight line (Baseline::rest)
/// for what is left of them. Both filters are oscillators solved exactly (Oscillator): H_1 gives
/// the acceleration of its mass in space, H_2 that against its ground. Clough & Penzien, Dynamics
/// of Structures (1993), chapter 28. Throws std::invalid_argument for a duration of fewer than two
/// steps, for noise that is shorter, and for parameters that are no filter or no envelope.
GroundRecord filtered_noise(std::vector<double> const& noise, NoiseMotion const& motion);

}  // namespace moraine
