// Histories of overpressure at a place that a blast passes.
#pragma once

#include <optional>

namespace moraine::blast {

/// Straight fall from the peak to zero: p (1 - t/t_0) for 0 <= t <= t_0, zero at other times.
/// Times from the arrival [s], peak in any unit.
double triangle_pulse(double peak, double duration, double time);

/// p t_0/2.
double triangle_impulse(double peak, double duration);

/// Friedlander's history: p (1 - t/t_0) e^(-k t/t_0) for t >= 0, zero before. Negative after the
/// duration t_0 of the positive phase; k >= 0 is the decay. Source: F. G. Friedlander, Proc. R.
/// Soc. A 186 (1946) 322.
double friedlander_pulse(double peak, double duration, double decay, double time);

/// Impulse of its positive phase: p t_0 [1/k - (1 - e^(-k))/k^2], p t_0/2 for k = 0.
double friedlander_impulse(double peak, double duration, double decay);

/// Lowest overpressure of its negative phase, -p e^(-1-k)/k at t = t_0 (1 + 1/k); k > 0.
double friedlander_suction(double peak, double duration, double decay);

/// Decay that gives a positive phase this impulse, or nothing unless 0 < I <= p t_0/2: then no
/// decay k >= 0 does.
std::optional<double> friedlander_decay(double peak, double duration, double impulse);

/// p e^(-t/theta), the shock of an explosion under water for t up to about theta.
double exponential_pulse(double peak, double time_constant, double time);

}  // namespace moraine::blast
