// Baseline correction: what a record has too much or too little.
#pragma once

#include <array>
#include <string_view>

#include "records/ground_record.hpp"

namespace moraine {

/// What is taken from the acceleration: the polynomial of this degree that is nearest to it (least
/// squares over all values), or, for `rest`, the straight line that leaves the ground at rest and
/// in its place at the end (v = d = 0).
enum class Baseline { none, mean, linear, quadratic, cubic, rest };

inline constexpr std::array<std::string_view, 6> baseline_names{"none",      "mean",  "linear",
                                                                "quadratic", "cubic", "rest"};

/// The corrected record. Throws std::invalid_argument where it has fewer values than the polynomial
/// has coefficients.
GroundRecord baseline_corrected(GroundRecord record, Baseline baseline);

}  // namespace moraine
