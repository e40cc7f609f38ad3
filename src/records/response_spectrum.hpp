// Response spectra: how oscillators of many periods answer a record.
#pragma once

#include <span>
#include <vector>

#include "records/ground_record.hpp"

namespace moraine {

/// Largest magnitudes of the answer of one oscillator, from rest.
struct SpectralResponse {
  double period = 0.0;               // s
  double displacement = 0.0;         // m, against the ground: Sd
  double velocity = 0.0;             // m/s, against the ground: Sv, the true one
  double acceleration = 0.0;         // m/s^2, in space: Sa
  double pseudo_velocity = 0.0;      // m/s, w Sd
  double pseudo_acceleration = 0.0;  // m/s^2, w^2 Sd
};

/// The answer of the oscillator with this period [s] and damping ratio, during the record and one
/// period after it, over resting ground. Exact at instants that part a period by a hundred or more
/// (Oscillator), so that a peak between them is low by less than 0.05 %. Throws
/// std::invalid_argument for a bad record, period or damping ratio.
/// With fewer `instants` a period, it is low by up to (pi/instants)^2 / 2.
SpectralResponse spectral_response(GroundRecord const& record, double period, double damping,
                                   double instants = 100.0);

/// The same for many periods.
std::vector<SpectralResponse> response_spectrum(GroundRecord const& record,
                                                std::span<double const> periods, double damping);

/// `count` periods [s] from `first` to `last` at equal ratios; both positive, count at least 2.
std::vector<double> periods_at_equal_ratios(double first, double last, std::size_t count);

/// The shortest period that a record can tell about [s]: five steps. Its straight lines hold
/// frequencies up to half of one over the step, and lose a third of the amplitude of a wave of
/// three steps, an eighth of one of five.
double shortest_period(double time_step);

}  // namespace moraine
