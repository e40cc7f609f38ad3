// A curve in one line of text.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace moraine::watch {

/// `width` blocks of eight heights, the lowest for the smallest value and the highest for the
/// largest: each stands for an equal piece of the values and shows that of them which is farthest
/// from the mean of all, so that peaks are seen. A blank where a piece holds no number; the lowest
/// block throughout where all values are equal.
std::string spark_line(std::span<double const> values, std::size_t width);

}  // namespace moraine::watch
