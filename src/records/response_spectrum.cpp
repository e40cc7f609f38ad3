#include "records/response_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "records/oscillator.hpp"

namespace moraine {
namespace {

class PeakFinder {
 public:
  PeakFinder(double period, double damping, double time_step, double instants)
      : parts_(std::max(1.0, std::ceil(instants * time_step / period))),
        oscillator_(2.0 * std::numbers::pi / period, damping, time_step / parts_) {}

  /// A step of the record, with the acceleration of the ground before and after.
  void step(double before, double after) {
    double a = before;
    for (double part = 1.0; part <= parts_; part += 1.0) {
      double const next = before + (after - before) * (part / parts_);
      state_ = oscillator_.advance(state_, a, next);
      a = next;
      look();
    }
  }

  /// A period over resting ground, after the record.
  void swing_on(double period, double damping) {
    constexpr int steps = 200;
    Oscillator const free(2.0 * std::numbers::pi / period, damping, period / steps);
    for (int i = 0; i < steps; ++i) {
      state_ = free.advance(state_, 0.0, 0.0);
      look();
    }
  }

  SpectralResponse result(double period) const {
    double const w = 2.0 * std::numbers::pi / period;
    return {period,        displacement_,     velocity_,
            acceleration_, w * displacement_, w * w * displacement_};
  }

 private:
  void look() {
    displacement_ = std::max(displacement_, std::fabs(state_.displacement));
    velocity_ = std::max(velocity_, std::fabs(state_.velocity));
    acceleration_ = std::max(acceleration_, std::fabs(oscillator_.absolute_acceleration(state_)));
  }

  double parts_;
  Oscillator oscillator_;
  OscillatorState state_;
  double displacement_ = 0.0, velocity_ = 0.0, acceleration_ = 0.0;
};

}  // namespace

SpectralResponse spectral_response(GroundRecord const& record, double period, double damping,
                                   double instants) {
  check_record(record);
  if (!(period > 0.0) || !std::isfinite(period))
    throw std::invalid_argument("response spectrum: the period must be positive");
  PeakFinder finder(period, damping, record.time_step, instants);
  for (std::size_t i = 1; i < record.size(); ++i)
    finder.step(record.acceleration[i - 1], record.acceleration[i]);
  finder.swing_on(period, damping);
  return finder.result(period);
}

std::vector<SpectralResponse> response_spectrum(GroundRecord const& record,
                                                std::span<double const> periods, double damping) {
  std::vector<SpectralResponse> spectrum;
  spectrum.reserve(periods.size());
  for (double const period : periods)
    spectrum.push_back(spectral_response(record, period, damping));
  return spectrum;
}

std::vector<double> periods_at_equal_ratios(double first, double last, std::size_t count) {
  if (!(first > 0.0 && last > 0.0 && count >= 2))
    throw std::invalid_argument("periods: both ends must be positive, and two or more of them");
  std::vector<double> periods(count);
  for (std::size_t i = 0; i < count; ++i)
    periods[i] =
        first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(count - 1));
  return periods;
}

double shortest_period(double time_step) { return 5.0 * time_step; }

}  // namespace moraine
