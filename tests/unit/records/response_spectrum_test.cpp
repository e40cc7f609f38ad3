#include "records/response_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/gravity.hpp"
#include "records/record_reader.hpp"
#include "support/records.hpp"
#include "support/shared_data.hpp"

namespace moraine {
namespace {

constexpr double pi = std::numbers::pi;

// Peaks lie at most half an instant from one that is looked at: (pi/100)^2 / 2.
constexpr double between_instants = 5e-4;

// A step of the ground swings to 1 + exp(-zeta pi / sqrt(1 - zeta^2)) times the static
// displacement.
TEST(ResponseSpectrum, StepInClosedForm) {
  GroundRecord const step = record_of(10.0, 0.01, [](double) { return 2.0; });
  for (double const zeta : {0.0, 0.02, 0.05, 0.2})
    for (double const period : {0.1, 0.37, 1.0, 3.0}) {
      double const w = 2.0 * pi / period;
      double const swing = 1.0 + std::exp(-zeta * pi / std::sqrt(1.0 - zeta * zeta));
      SpectralResponse const r = spectral_response(step, period, zeta);
      EXPECT_NEAR(r.pseudo_acceleration, 2.0 * swing, between_instants * 4.0);
      EXPECT_DOUBLE_EQ(r.displacement, r.pseudo_acceleration / (w * w));
      EXPECT_DOUBLE_EQ(r.pseudo_velocity, w * r.displacement);
    }
}

// Harmonic ground in resonance: the steady amplitude is A / (2 zeta w^2), and the velocity and the
// absolute acceleration A/(2 zeta w) and A sqrt(1 + 4 zeta^2) / (2 zeta).
TEST(ResponseSpectrum, ResonanceInClosedForm) {
  double const zeta = 0.05, period = 0.5, w = 2.0 * pi / period;
  GroundRecord const record = sine_record(1.0, 1.0 / period, 40.0, 0.0025);
  SpectralResponse const r = spectral_response(record, period, zeta);
  EXPECT_NEAR(r.displacement, 1.0 / (2.0 * zeta * w * w), 1e-3 / (2.0 * zeta * w * w));
  EXPECT_NEAR(r.velocity, 1.0 / (2.0 * zeta * w), 1e-3 / (2.0 * zeta * w));
  EXPECT_NEAR(r.acceleration, std::sqrt(1.0 + 4.0 * zeta * zeta) / (2.0 * zeta), 1e-2);
}

// Far from resonance: w^2 A / |w^2 - w_g^2| (1 + w_g/w) bounds what an undamped oscillator answers
// to a sine from rest, and is met where the two waves meet with opposite signs, here within 40
// periods to 1 %.
TEST(ResponseSpectrum, BeatOfAnUndampedOscillator) {
  double const w_g = 2.0 * pi, period = 1.0 / std::sqrt(7.0), w = 2.0 * pi / period;
  SpectralResponse const r = spectral_response(sine_record(1.0, 1.0, 40.0, 0.005), period, 0.0);
  double const bound = (1.0 + w_g / w) / (w * w - w_g * w_g);
  EXPECT_LT(r.displacement, bound);
  EXPECT_GT(r.displacement, 0.99 * bound);
}

// A short pulse leaves an oscillation behind, 2 A/w^2 sin(pi t_d/T), after the record has ended.
TEST(ResponseSpectrum, FreeSwingAfterAPulse) {
  double const length = 0.1, dt = 0.001;
  // Straight sides of one step: the pulse is as long between the middles of its sides.
  GroundRecord const pulse =
      record_of(length + dt, dt, [&](double t) { return t > 0.5 * dt && t < length + 0.5 * dt; });
  for (double const period : {0.3, 0.5, 2.0}) {
    double const w = 2.0 * pi / period;
    double const exact = 2.0 / (w * w) * std::sin(pi * length / period);
    EXPECT_NEAR(spectral_response(pulse, period, 0.0).displacement, exact, 1e-3 * exact) << period;
  }
}

// How fine the steps are does not matter for what comes after the record: a pulse cut into steps of
// 1e-9 s still has the peak w x impulse of its free swing, and that of a record without end.
TEST(ResponseSpectrum, SwingsOnAfterTheRecordAtOnce) {
  GroundRecord const pulse = record_of(1e-7, 1e-9, [](double) { return 1.0; });
  for (double const period : {0.1, 2.0}) {
    double const w = 2.0 * pi / period;
    EXPECT_NEAR(spectral_response(pulse, period, 0.0).displacement, 1e-7 / w, 1e-3 * 1e-7 / w);
  }
  GroundRecord const record = sine_record(1.0, 3.0, 1.0, 0.01);
  GroundRecord longer = record;
  longer.acceleration.resize(record.size() + 500, 0.0);
  for (double const period : {0.2, 0.7, 3.0}) {
    double const expected = spectral_response(longer, period, 0.05).displacement;
    EXPECT_NEAR(spectral_response(record, period, 0.05).displacement, expected, 1e-3 * expected);
  }
}

// Very stiff oscillators move with the ground, very soft ones stay where they are.
TEST(ResponseSpectrum, EndsAtThePeaksOfTheGround) {
  double const f = 2.0;
  GroundRecord const record = sine_record(3.0, f, 4.0, 0.005);
  GroundPath const path = integrate(record);
  EXPECT_NEAR(spectral_response(record, 0.01, 0.05).pseudo_acceleration, 3.0, 0.01);
  double const ground = peak_of(record, path.displacement).value;
  EXPECT_NEAR(spectral_response(record, 2000.0, 0.05).displacement, ground, 5e-3 * ground);
}

// Without damping the absolute acceleration is w^2 times the displacement.
TEST(ResponseSpectrum, PseudoIsTrueWithoutDamping) {
  GroundRecord const record = sine_record(3.0, 1.7, 4.0, 0.005);
  for (auto const& r : response_spectrum(record, periods_at_equal_ratios(0.05, 5.0, 20), 0.0))
    EXPECT_NEAR(r.acceleration, r.pseudo_acceleration, 1e-12 * r.acceleration);
}

// Chopra, Dynamics of Structures, fig. 6.4.1 and table 6.4: El Centro N-S, 2 % damping; printed to
// three digits, and the record has several versions.
TEST(ResponseSpectrum, ElCentroAsPublished) {
  auto const file = shared_data("seismic/elcentro1940_NS_peknold.csv");
  if (file.empty()) GTEST_SKIP() << no_shared_data;
  GroundRecord const record = read_record(file, {});
  constexpr double inch = 0.0254;
  struct Published {
    double period, displacement, velocity, acceleration;  // s, inch, inch/s, g
  };
  for (Published const& p : {Published{0.5, 2.67, 33.7, 1.09}, Published{1.0, 5.97, 37.5, 0.610},
                             Published{2.0, 7.47, 23.5, 0.191}}) {
    SpectralResponse const r = spectral_response(record, p.period, 0.02);
    EXPECT_NEAR(r.displacement / inch, p.displacement, 0.01 * p.displacement);
    EXPECT_NEAR(r.pseudo_velocity / inch, p.velocity, 0.01 * p.velocity);
    EXPECT_NEAR(r.pseudo_acceleration / standard_gravity, p.acceleration, 0.01 * p.acceleration);
  }
  EXPECT_NEAR(peak_of(record, integrate(record).displacement).value / inch, 8.40, 0.01);
}

}  // namespace
}  // namespace moraine
