// Records in closed form.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "records/ground_record.hpp"

namespace moraine {

/// The record of a function of time [s] with values in m/s^2.
inline GroundRecord record_of(double duration, double time_step,
                              std::function<double(double)> const& acceleration) {
  GroundRecord record{"made", time_step, 0.0, {}};
  auto const steps = static_cast<std::size_t>(std::lround(duration / time_step));
  for (std::size_t i = 0; i <= steps; ++i)
    record.acceleration.push_back(acceleration(record.time(i)));
  return record;
}

/// A sin(2 pi f t).
inline GroundRecord sine_record(double amplitude, double frequency, double duration,
                                double time_step) {
  return record_of(duration, time_step, [=](double t) {
    return amplitude * std::sin(2.0 * std::numbers::pi * frequency * t);
  });
}

}  // namespace moraine
