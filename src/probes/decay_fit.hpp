// How a quantity falls off with distance.
#pragma once

#include <cstddef>
#include <span>

namespace moraine {

/// A power law a(r) = c r^-n through measured values.
struct DecayFit {
  double exponent;         // -n: negative where the values fall with the distance
  double scatter;          // root mean square of the differences of ln a to the line
  std::size_t points = 0;  // values that the fit is of
};

/// Least-squares line of ln(value) against ln(distance),
///
///   -n = sum (x - mean x)(y - mean y) / sum (x - mean x)^2,  x = ln r, y = ln a.
///
/// Values and distances that are not positive numbers are left out. Exponent and scatter are not
/// numbers where fewer than two different distances are left. Both spans have the same length;
/// distances in m, values in any unit.
DecayFit fit_decay(std::span<double const> distances, std::span<double const> values);

}  // namespace moraine
