// Values of a range: evenly spread, or drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moraine {

/// The values from `low` to `high`, on a linear or a logarithmic scale; 0 < low, high on the
/// latter.
struct ValueRange {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;

  /// The value at a share of the way, 0 to 1; rounded to 12 significant digits, so that it reads
  /// well and is the same on every machine.
  double at(double share) const;
};

/// `steps` values at equal distances, both ends included; the middle for one.
std::vector<double> even_values(ValueRange const& range, std::size_t steps);

/// Which of `count` values a place from 0 to 1 stands for, each having an equal part of it.
std::size_t value_at(double place, std::size_t count);

/// Latin hypercube: `samples` points in [0, 1)^dimensions, as [dimension][sample]. Along each
/// dimension each of the `samples` strata of equal width holds one point, at a random place in it.
/// McKay, Beckman and Conover, Technometrics 21 (1979) 239, section 2.3. The generator is the
/// 64-bit Mersenne twister, the rest is done here: the same seed gives the same points on any
/// machine.
std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t samples,
                                                 std::uint64_t seed);

}  // namespace moraine
