#include "records/butterworth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "support/records.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double dt = 0.005, length = 120.0;

/// Amplitude and phase of the middle third of a record at a frequency, against sin(2 pi f t).
std::complex<double> wave_at(GroundRecord const& record, double frequency) {
  std::complex<double> sum;
  double count = 0.0;
  for (std::size_t i = record.size() / 3; i < 2 * record.size() / 3; ++i, count += 1.0)
    sum += record.acceleration[i] *
           std::exp(std::complex<double>(0.0, -2.0 * pi * frequency * record.time(i)));
  return sum * std::complex<double>(0.0, 2.0) / count;
}

std::complex<double> gain(Butterworth const& filter, double frequency) {
  return wave_at(filtered(sine_record(1.0, frequency, length, dt), filter), frequency);
}

double decibel(double amplitude) { return 20.0 * std::log10(amplitude); }

// Third of the record: 40 s, so that other waves weigh at most 1/(40 pi df).
constexpr double leak = 2e-3;

TEST(Butterworth, CornerIsMinusThreeAndMinusSixDecibel) {
  for (auto const band : {Passband::low, Passband::high})
    for (int order = 1; order <= 8; ++order) {
      double const once = std::abs(gain({band, 5.0, order, Passes::forward}, 5.0));
      double const twice = std::abs(gain({band, 5.0, order, Passes::both_ways}, 5.0));
      EXPECT_NEAR(decibel(once), -3.0103, 0.02) << order;
      EXPECT_NEAR(decibel(twice), -6.0206, 0.02) << order;
    }
}

TEST(Butterworth, GainsFollowTheFormula) {
  for (int const order : {1, 2, 3, 5})
    for (double const f : {1.0, 3.0, 4.5, 8.0, 20.0}) {
      double const ratio = std::tan(pi * f * dt) / std::tan(pi * 5.0 * dt);
      double const power = std::pow(ratio, 2 * order);
      EXPECT_NEAR(std::abs(gain({Passband::low, 5.0, order, Passes::forward}, f)),
                  1.0 / std::sqrt(1.0 + power), leak)
          << order << ' ' << f;
      EXPECT_NEAR(std::abs(gain({Passband::high, 5.0, order, Passes::both_ways}, f)),
                  power / (1.0 + power), leak)
          << order << ' ' << f;
    }
}

TEST(Butterworth, BothWaysMoveNothing) {
  for (double const f : {1.0, 5.0, 7.0}) {
    EXPECT_NEAR(std::arg(gain({Passband::low, 5.0, 2, Passes::both_ways}, f)), 0.0, leak) << f;
    EXPECT_NEAR(std::arg(gain({Passband::high, 5.0, 2, Passes::both_ways}, f)), 0.0, 5.0 * leak);
  }
  // One pass of the second order lags by a quarter at the corner.
  EXPECT_NEAR(std::arg(gain({Passband::low, 5.0, 2, Passes::forward}, 5.0)), -pi / 2.0, leak);
}

// Backward is forward on the reversed record: a record that reads the same both ways stays so.
TEST(Butterworth, KeepsSymmetry) {
  GroundRecord const bump = record_of(40.0, dt, [](double t) {
    return std::exp(-(t - 20.0) * (t - 20.0)) * std::cos(12.0 * (t - 20.0));
  });
  GroundRecord const low = filtered(bump, {Passband::low, 3.0, 4, Passes::both_ways});
  ASSERT_EQ(low.size(), bump.size());
  for (std::size_t i = 0; i < low.size() / 2; ++i)
    EXPECT_NEAR(low.acceleration[i], low.acceleration[low.size() - 1 - i], 1e-12);
}

TEST(Butterworth, RefusesCornersThatTheStepCannotHold) {
  GroundRecord const record = sine_record(1.0, 1.0, 10.0, 0.02);
  auto const refusal = [&](Butterworth const& filter) {
    return message_of<std::invalid_argument>([&] { filtered(record, filter); });
  };
  auto const corner = [](std::string const& found) {
    return "Butterworth filter: the corner, " + found +
           " Hz, must lie between 3.2e-05 Hz and half of one over the time step, 25 Hz";
  };
  EXPECT_EQ(refusal({Passband::low, 25.0, 2, Passes::forward}), corner("25"));
  EXPECT_EQ(refusal({Passband::low, 0.0, 2, Passes::forward}), corner("0"));
  // It would ring for longer than there is memory.
  EXPECT_EQ(refusal({Passband::high, 1e-9, 2, Passes::both_ways}), corner("1e-09"));
  EXPECT_EQ(refusal({Passband::low, 9.0, 9, Passes::forward}),
            "Butterworth filter: the order must be 1 to 8");
}

}  // namespace
}  // namespace moraine
