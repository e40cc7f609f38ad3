// What becomes of the values of a formula.
#pragma once

#include <cstdint>

namespace moraine {

/// The largest, the smallest, the weighted mean, the sum over particles, the integral over their
/// volume.
enum class Reduction : std::uint8_t { max, min, mean, sum, integral };

/// Weight of each particle in a mean.
enum class MeanWeight : std::uint8_t { mass, volume, number };

}  // namespace moraine
