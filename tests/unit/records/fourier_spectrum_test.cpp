#include "records/fourier_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "records/synthetic_motion.hpp"
#include "support/records.hpp"

namespace moraine {
namespace {

double sum_of_squares(GroundRecord const& record) {
  return std::inner_product(record.acceleration.begin(), record.acceleration.end(),
                            record.acceleration.begin(), 0.0);
}

// sum a^2 dt = df (F_0^2 + 2 sum F_k^2 + F_last^2), for lengths with and without small factors.
TEST(FourierSpectrum, Parseval) {
  for (std::size_t const length : {2U, 3U, 97U, 1000U, 1559U, 4099U}) {
    GroundRecord const record{"", 0.02, 0.0, white_noise(length, length)};
    FrequencySpectrum const f = fourier_spectrum(record);
    double sum = 0.0;
    for (double const value : f.values) sum += 2.0 * value * value;
    sum -= f.values.front() * f.values.front() + f.values.back() * f.values.back();
    double const power = sum_of_squares(record) * record.time_step;
    EXPECT_NEAR(sum * f.frequency_step, power, 1e-12 * power) << length;
    EXPECT_NEAR(f.frequency(f.values.size() - 1), 25.0, 1e-12);
  }
}

TEST(FourierSpectrum, PowerIntegratesToTheMeanSquare) {
  GroundRecord const record{"", 0.02, 0.0, white_noise(1559, 3)};
  FrequencySpectrum const power = power_spectrum(record);
  double const sum = std::accumulate(power.values.begin(), power.values.end(), 0.0);
  double const mean = sum_of_squares(record) / 1559.0;
  EXPECT_NEAR(sum * power.frequency_step, mean, 1e-12 * mean);
}

// A sine of the length T has the amplitude A T/2 at its frequency; a whole number of cycles.
TEST(FourierSpectrum, PeakOfASine) {
  GroundRecord const record = sine_record(3.0, 2.5, 40.0 - 0.01, 0.01);
  FrequencySpectrum const f = fourier_spectrum(record);
  auto const k = static_cast<std::size_t>(std::lround(2.5 / f.frequency_step));
  EXPECT_NEAR(f.values[k], 3.0 * 40.0 / 2.0, 0.01);
  EXPECT_NEAR(dominant_frequency(record), 2.5, 0.5 * f.frequency_step);
  EXPECT_LT(f.frequency_step, 1.0 / 40.0);
}

// exp(-c t) has the transform 1/(c + 2 pi i f), sampled finely: to the order of the step.
TEST(FourierSpectrum, DecayInClosedForm) {
  double const c = 2.0;
  GroundRecord record = record_of(20.0, 0.001, [&](double t) { return std::exp(-c * t); });
  record.acceleration.front() *= 0.5;  // of the jump at the start
  FrequencySpectrum const f = fourier_spectrum(record);
  for (std::size_t k = 0; f.frequency(k) < 5.0; k += 7)
    EXPECT_NEAR(f.values[k], 1.0 / std::hypot(c, 2.0 * std::numbers::pi * f.frequency(k)), 1e-5);
}

}  // namespace
}  // namespace moraine
