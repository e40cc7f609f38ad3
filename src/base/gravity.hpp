// Gravity.
#pragma once

namespace moraine {

/// Standard acceleration of free fall [m/s^2]: the unit g0 of records. Source: 3rd General
/// Conference on Weights and Measures (1901), by definition.
inline constexpr double standard_gravity = 9.80665;

}  // namespace moraine
