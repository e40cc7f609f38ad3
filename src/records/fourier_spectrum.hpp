// Frequencies of a record.
#pragma once

#include <vector>

#include "records/ground_record.hpp"

namespace moraine {

/// Values at the frequencies 0, df, 2 df, ... up to half of one over the time step.
struct FrequencySpectrum {
  double frequency_step = 0.0;  // Hz
  std::vector<double> values;

  double frequency(std::size_t k) const { return static_cast<double>(k) * frequency_step; }  // Hz
};

/// Magnitude of the Fourier transform, |sum_i a_i exp(-2 pi i f t_i)| dt [m/s]. The record is
/// followed by rest, up to the next even length of small factors that is at least twice as long, so
/// that frequencies lie closer than one over the duration. Parseval:
///   sum a^2 dt = df (F_0^2 + 2 sum F_k^2 + F_last^2)
FrequencySpectrum fourier_spectrum(GroundRecord const& record);

/// One-sided power spectral density, 2 F^2 / (N dt) [m^2/s^4/Hz] (once at 0 and at the last
/// frequency), whose integral df sum S_k is the mean square of the N values: the periodogram,
/// unsmoothed. Source: Bendat & Piersol, Random Data (2010), chapter 11.
FrequencySpectrum power_spectrum(GroundRecord const& record);

/// The frequency with the largest power [Hz].
double dominant_frequency(GroundRecord const& record);

}  // namespace moraine
