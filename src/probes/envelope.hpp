// What each particle has been through: the largest pressure, when it came, and its impulse.
#pragma once

#include <cstdint>
#include <vector>

#include "base/archive.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// Envelopes of the pressure of every fluid particle, by global id, from the first call of `tell`:
///
///   peak = max p,   arrival = first t with p - p_0 >= rise,   impulse = integral of (p - p_0) dt
///
/// p_0 is the particle's pressure at the first call. The arrival is interpolated linearly between
/// the two steps around it, the integral is that of the trapezoidal rule over the steps. A particle
/// that leaves the domain keeps what it had.
class PressureEnvelope {
 public:
  /// rise: what counts as arrival [Pa], positive.
  explicit PressureEnvelope(double rise) : rise_(rise) {}

  /// Call at the start and after each step; time in s.
  void tell(ParticleStore const& store, double time);

  /// By global id: Pa, s, s (not a number where nothing has arrived), Pa s.
  std::vector<double> const& peak() const { return peak_; }
  std::vector<double> const& time_of_peak() const { return time_of_peak_; }
  std::vector<double> const& arrival() const { return arrival_; }
  std::vector<double> const& impulse() const { return impulse_; }

  void exchange(Archive& archive);

 private:
  void start(ParticleStore const& store, double time);

  double rise_;
  double last_time_ = 0.0;
  std::vector<double> start_, last_;  // Pa
  std::vector<double> peak_, time_of_peak_, arrival_, impulse_;
};

}  // namespace moraine
