// What must be true of the measures of any record.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/gravity.hpp"
#include "records/fourier_spectrum.hpp"
#include "records/measures.hpp"
#include "records/motion_fit.hpp"
#include "records/record_reader.hpp"
#include "records/record_writer.hpp"
#include "records/response_spectrum.hpp"

namespace moraine {
namespace {

GroundRecord random_record(std::uint64_t seed) {
  NoiseMotion motion;
  motion.duration = 12.0 + static_cast<double>(seed);
  motion.peak = 0.5 + 0.3 * static_cast<double>(seed % 5);
  motion.filter.ground_frequency = 1.0 + static_cast<double>(seed % 4);
  motion.filter.corner_frequency = 0.15;
  return filtered_noise(white_noise(8001, seed), motion);
}

class AnyRecord : public testing::TestWithParam<std::uint64_t> {};

void expect_ratio(double a, double b, double ratio, char const* what) {
  EXPECT_NEAR(a / b, ratio, 1e-9 * ratio) << what;
}

// Twice the acceleration: twice the peaks and spectra, four times the energies, the same times.
TEST_P(AnyRecord, ScalesWithTheAcceleration) {
  GroundRecord const record = random_record(GetParam());
  GroundRecord twice = record;
  for (double& a : twice.acceleration) a *= 2.0;
  MotionMeasures const m = measure(record), n = measure(twice);
  expect_ratio(n.acceleration.value, m.acceleration.value, 2.0, "PGA");
  expect_ratio(n.velocity.value, m.velocity.value, 2.0, "PGV");
  expect_ratio(n.displacement.value, m.displacement.value, 2.0, "PGD");
  expect_ratio(n.rms_acceleration, m.rms_acceleration, 2.0, "rms");
  expect_ratio(n.arias_intensity, m.arias_intensity, 4.0, "Arias");
  expect_ratio(n.characteristic_intensity, m.characteristic_intensity, std::pow(2.0, 1.5), "Ic");
  expect_ratio(n.cumulative_velocity, m.cumulative_velocity, 2.0, "CAV");
  expect_ratio(n.specific_energy_density, m.specific_energy_density, 4.0, "SED");
  expect_ratio(n.velocity_intensity, m.velocity_intensity, 2.0, "VSI");
  expect_ratio(n.housner_intensity, m.housner_intensity, 2.0, "Housner");
  expect_ratio(n.acceleration_intensity, m.acceleration_intensity, 2.0, "ASI");
  expect_ratio(n.design_acceleration, m.design_acceleration, 2.0, "EDA");
  expect_ratio(n.sustained_acceleration, m.sustained_acceleration, 2.0, "sustained");
  expect_ratio(n.a95, m.a95, 2.0, "A95");
  EXPECT_NEAR(n.significant.length(), m.significant.length(), 1e-9);
  EXPECT_NEAR(n.predominant_period, m.predominant_period, 1e-9);
  EXPECT_GE(n.bracketed.length(), m.bracketed.length());
}

// Time over four: velocities over 4, displacements over 16, energies over 4 and 64, periods over 4.
TEST_P(AnyRecord, ScalesWithTheTime) {
  GroundRecord const record = random_record(GetParam());
  GroundRecord const model = time_scaled(record, 0.25);
  MotionMeasures const m = measure(record), n = measure(model);
  EXPECT_EQ(n.acceleration.value, m.acceleration.value);
  expect_ratio(n.velocity.value, m.velocity.value, 1.0 / 4.0, "PGV");
  expect_ratio(n.displacement.value, m.displacement.value, 1.0 / 16.0, "PGD");
  expect_ratio(n.arias_intensity, m.arias_intensity, 1.0 / 4.0, "Arias");
  expect_ratio(n.cumulative_velocity, m.cumulative_velocity, 1.0 / 4.0, "CAV");
  expect_ratio(n.specific_energy_density, m.specific_energy_density, 1.0 / 64.0, "SED");
  expect_ratio(n.significant.length(), m.significant.length(), 1.0 / 4.0, "D5-95");
  expect_ratio(n.rms_acceleration, m.rms_acceleration, 1.0, "rms");
  expect_ratio(dominant_frequency(model), dominant_frequency(record), 4.0, "frequency");
  for (double const period : {0.1, 0.5, 2.0})
    expect_ratio(spectral_response(model, 0.25 * period, 0.05).pseudo_acceleration,
                 spectral_response(record, period, 0.05).pseudo_acceleration, 1.0, "PSA");
  EXPECT_NEAR(n.predominant_period, 0.25 * m.predominant_period, 3e-4 * m.predominant_period);
}

// Written in any unit, read in that unit, it is the same record.
TEST_P(AnyRecord, ReadsTheSameInAnyUnit) {
  GroundRecord const record = random_record(GetParam());
  for (auto const* unit : {"g", "m/s2", "cm/s2", "gal", "ft/s^2"}) {
    std::string text;
    for (double const a : record.acceleration)
      text += std::to_string(a / *acceleration_unit(unit) * 1e3) + "e-3\n";
    GroundRecord const back = parse_record(text, "q", {unit, record.time_step});
    double worst = 0.0;
    for (std::size_t i = 0; i < record.size(); ++i)
      worst = std::max(worst, std::fabs(back.acceleration[i] - record.acceleration[i]));
    EXPECT_LE(worst, 0.51e-9 * *acceleration_unit(unit)) << unit << ": nine decimals were written";
  }
}

// Order among measures that holds for every record.
TEST_P(AnyRecord, MeasuresKeepTheirOrder) {
  MotionMeasures const m = measure(random_record(GetParam()));
  EXPECT_LE(m.rms_acceleration, m.a95);
  EXPECT_LE(m.a95, m.acceleration.value);
  EXPECT_LE(m.sustained_acceleration, m.acceleration.value);
  EXPECT_LE(m.significant.length(), m.duration);
  EXPECT_LE(m.bracketed.length(), m.duration);
  EXPECT_LE(m.cumulative_velocity, m.rms_acceleration * m.duration * (1.0 + 1e-12));
  EXPECT_LE(m.velocity.value, m.cumulative_velocity);
}

// Duhamel's integral is at most int |a| dt / w_d, so that PSV <= CAV / sqrt(1 - zeta^2).
TEST_P(AnyRecord, SpectraAreBoundedByTheCumulativeVelocity) {
  GroundRecord const record = random_record(GetParam());
  double const cav = cumulative_absolute_velocity(record);
  for (double const damping : {0.0, 0.05, 0.5})
    for (auto const& r : response_spectrum(record, periods_at_equal_ratios(0.1, 10.0, 20), damping))
      EXPECT_LE(r.pseudo_velocity, cav / std::sqrt(1.0 - damping * damping));
}

// An undamped oscillator swings on, after the record, with the pseudo velocity |F(f)|, the Fourier
// amplitude of the straight lines between the values: that of the values times sinc^2(f dt). So its
// spectrum is nowhere below that.
TEST_P(AnyRecord, UndampedSpectraAreAboveTheFourierAmplitude) {
  GroundRecord const record = random_record(GetParam());
  FrequencySpectrum const fourier = fourier_spectrum(record);
  for (std::size_t k = 5; fourier.frequency(k) < 10.0; k += 37) {
    double const f = fourier.frequency(k), x = std::numbers::pi * f * record.time_step;
    double const swing = fourier.values[k] * std::pow(std::sin(x) / x, 2);
    // 1e-3: peaks between instants, and the jump of the last value to zero.
    EXPECT_GE(spectral_response(record, 1.0 / f, 0.0).pseudo_velocity, swing * (1.0 - 1e-3)) << f;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnyRecord, testing::Values(1, 2, 3, 4, 5, 6));

}  // namespace
}  // namespace moraine
