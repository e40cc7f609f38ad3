// The motion of the ground along one direction, as it was recorded.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace moraine {

/// Acceleration of the ground at equal steps of time, joined by straight lines.
struct GroundRecord {
  std::string name;
  double time_step = 0.0;            // s, positive
  double start = 0.0;                // s, time of the first value
  std::vector<double> acceleration;  // m/s^2, at least two values

  std::size_t size() const { return acceleration.size(); }
  double time(std::size_t i) const { return start + static_cast<double>(i) * time_step; }  // s
  /// From the first to the last value [s].
  double duration() const { return static_cast<double>(size() - 1) * time_step; }
};

/// Throws std::invalid_argument unless the record has two values or more, all finite, and a step
/// that is positive and finite, and ends before 1e12 s.
void check_record(GroundRecord const& record);

/// A peak of a history: the largest magnitude and its first time.
struct Peak {
  double value = 0.0;  // magnitude, unit of the history
  double time = 0.0;   // s
};

/// The largest magnitude of values at the times of a record.
Peak peak_of(GroundRecord const& record, std::vector<double> const& values);

/// The record times the factor that brings its largest magnitude to `peak` [m/s^2]. Throws
/// std::invalid_argument where the peak is not positive or the record is zero throughout.
GroundRecord scaled_to_peak(GroundRecord record, double peak);

/// The same accelerations at times multiplied by `factor`: velocities change by the factor,
/// displacements by its square. Throws std::invalid_argument unless the factor is positive.
GroundRecord time_scaled(GroundRecord record, double factor);

/// What is recorded up to `end` [s], with a last value there or less than a step before. Throws
/// std::invalid_argument where fewer than two values are left.
GroundRecord cut_after(GroundRecord record, double end);

/// Velocity and displacement of the ground, both zero at the first value.
struct GroundPath {
  std::vector<double> velocity;      // m/s
  std::vector<double> displacement;  // m
};

/// Integrates an acceleration that runs straight from value to value, exactly:
///   v_1 = v_0 + (a_0 + a_1) dt/2,   d_1 = d_0 + v_0 dt + (2 a_0 + a_1) dt^2/6.
GroundPath integrate(GroundRecord const& record);

}  // namespace moraine
