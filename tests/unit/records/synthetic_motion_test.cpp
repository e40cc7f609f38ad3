#include "records/synthetic_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "records/fourier_spectrum.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

// Moments of 200 000 normal numbers: mean 0, variance 1, third 0, fourth 3, each within four
// standard errors (1, sqrt 2, sqrt 15, sqrt 96 over the root of the number), no neighbour
// correlated.
TEST(WhiteNoise, IsNormalAndWhite) {
  std::size_t const count = 200'000;
  auto const noise = white_noise(count, 1);
  ASSERT_EQ(noise.size(), count);
  double moments[5] = {}, neighbours = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 1; k <= 4; ++k) moments[k] += std::pow(noise[i], k) / static_cast<double>(count);
    if (i > 0) neighbours += noise[i] * noise[i - 1] / static_cast<double>(count);
  }
  double const unit = 4.0 / std::sqrt(static_cast<double>(count));
  EXPECT_NEAR(moments[1], 0.0, unit);
  EXPECT_NEAR(moments[2], 1.0, std::sqrt(2.0) * unit);
  EXPECT_NEAR(moments[3], 0.0, std::sqrt(15.0) * unit);
  EXPECT_NEAR(moments[4], 3.0, std::sqrt(96.0) * unit);
  EXPECT_NEAR(neighbours, 0.0, unit);
}

TEST(WhiteNoise, SameSeedSameBits) {
  EXPECT_EQ(white_noise(1001, 7), white_noise(1001, 7));
  EXPECT_NE(white_noise(1001, 7), white_noise(1001, 8));
  auto const longer = white_noise(2000, 7), shorter = white_noise(1000, 7);
  EXPECT_TRUE(std::equal(shorter.begin(), shorter.end(), longer.begin()));
}

TEST(Envelope, RisesStaysAndFalls) {
  Envelope const envelope{0.2, 0.6};
  EXPECT_EQ(envelope.at(0.0), 0.0);
  EXPECT_DOUBLE_EQ(envelope.at(0.1), 0.25);
  EXPECT_EQ(envelope.at(0.2), 1.0);
  EXPECT_EQ(envelope.at(0.6), 1.0);
  EXPECT_NEAR(envelope.at(1.0), 0.05, 1e-15);
}

// A single number of noise comes out as the answer of both filters, whose spectrum is
// H_1 H_2 sinc^2(f dt), where the envelope stays one.
TEST(FilteredNoise, HasTheSpectrumOfKanaiTajimiAndCloughPenzien) {
  NoiseMotion motion;
  motion.duration = 80.0;
  motion.time_step = motion.noise_step = 0.01;
  motion.filter = {2.5, 0.4, 0.3, 0.6};
  motion.envelope = {0.01, 0.98};
  std::vector<double> noise(8001, 0.0);
  noise[1000] = 1.0;
  FrequencySpectrum const spectrum = fourier_spectrum(filtered_noise(noise, motion));
  auto const expected = [&](double f) {
    std::complex<double> const i(0.0, 1.0);
    double const r = f / 2.5, q = f / 0.3, x = std::numbers::pi * f * 0.01;
    auto const h_1 = (1.0 + 2.0 * i * 0.4 * r) / (1.0 - r * r + 2.0 * i * 0.4 * r);
    auto const h_2 = q * q / (1.0 - q * q + 2.0 * i * 0.6 * q);
    return std::abs(h_1 * h_2) * std::pow(std::sin(x) / x, 2);
  };
  auto const at = [&](double f) {
    return spectrum.values[static_cast<std::size_t>(std::lround(f / spectrum.frequency_step))];
  };
  double const scale = at(2.5) / expected(2.5);
  for (double const f : {0.1, 0.3, 0.6, 1.0, 2.0, 4.0, 8.0, 15.0})
    EXPECT_NEAR(at(f) / scale, expected(f), 0.01 * expected(2.5)) << f;
}

TEST(FilteredNoise, EndsAtRestWithItsPeak) {
  NoiseMotion motion;
  motion.peak = 3.0;
  GroundRecord const record = filtered_noise(white_noise(4001, 3), motion);
  ASSERT_EQ(record.size(), 4001u);
  EXPECT_EQ(peak_of(record, record.acceleration).value, 3.0);
  GroundPath const path = integrate(record);
  EXPECT_NEAR(path.velocity.back(), 0.0, 1e-12);
  EXPECT_NEAR(path.displacement.back(), 0.0, 1e-11);
}

TEST(FilteredNoise, RefusesWhatCannotBe) {
  auto const refusal = [](NoiseMotion const& motion, std::size_t count) {
    return message_of<std::invalid_argument>(
        [&] { filtered_noise(white_noise(count, 1), motion); });
  };
  EXPECT_EQ(refusal({}, 4000), "noise: there are too few numbers for the duration");
  NoiseMotion motion;
  motion.envelope = {0.5, 0.4};
  EXPECT_EQ(refusal(motion, 4001), "envelope: it must rise, stay and fall between 0 and 1");
  motion = {};
  motion.duration = 0.005;
  EXPECT_EQ(refusal(motion, 4001), "noise: the duration must be two steps or more");
}

}  // namespace
}  // namespace moraine
