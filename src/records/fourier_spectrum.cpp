#include "records/fourier_spectrum.hpp"

#include <algorithm>
#include <complex>
#include <kissfft.hh>

namespace moraine {
namespace {

/// The first even number from `least` on with no prime factor above 5.
std::size_t transform_length(std::size_t least) {
  for (std::size_t n = least + least % 2;; n += 2) {
    std::size_t rest = n;
    for (std::size_t const factor : {2U, 3U, 5U})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

}  // namespace

FrequencySpectrum fourier_spectrum(GroundRecord const& record) {
  check_record(record);
  std::size_t const length = transform_length(2 * record.size());
  // Of KISS FFT, whose licence (BSD) leaves ours as it is; FFTW's (GPL) would not.
  std::vector<std::complex<double>> in(length), out(length);
  std::copy(record.acceleration.begin(), record.acceleration.end(), in.begin());
  kissfft<double>(length, false).transform(in.data(), out.data());
  FrequencySpectrum spectrum{1.0 / (static_cast<double>(length) * record.time_step),
                             std::vector<double>(length / 2 + 1)};
  for (std::size_t k = 0; k < spectrum.values.size(); ++k)
    spectrum.values[k] = std::abs(out[k]) * record.time_step;
  return spectrum;
}

FrequencySpectrum power_spectrum(GroundRecord const& record) {
  FrequencySpectrum spectrum = fourier_spectrum(record);
  double const length = static_cast<double>(record.size()) * record.time_step;
  for (double& value : spectrum.values) value = 2.0 * value * value / length;
  spectrum.values.front() *= 0.5;
  spectrum.values.back() *= 0.5;
  return spectrum;
}

double dominant_frequency(GroundRecord const& record) {
  FrequencySpectrum const power = power_spectrum(record);
  auto const largest = std::max_element(power.values.begin(), power.values.end());
  return power.frequency(static_cast<std::size_t>(largest - power.values.begin()));
}

}  // namespace moraine
