// Places and values as 16-bit numbers over their range.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace moraine::report {

/// The smallest interval that holds all finite values told; [0, 0] where there are none.
class Interval {
 public:
  void include(double value);
  double min() const { return any_ ? min_ : 0.0; }
  double max() const { return any_ ? max_ : 0.0; }

 private:
  double min_ = 0.0, max_ = 0.0;
  bool any_ = false;
};

/// Of places and of values: the number after the last step stands for "none".
inline constexpr double steps_of_16_bits = 65534.0;

/// round((value - min) / (max - min) steps), cut off at 0 and the 65534 steps; 0 in an interval
/// without length; 65535 for what is not finite.
std::vector<std::uint16_t> quantised(std::span<double const> values, Interval const& interval);

}  // namespace moraine::report
