// Powers with exponents that are nearly always whole.
#pragma once

#include <cmath>

#include "base/macros.hpp"

namespace moraine {

/// x^exponent for x >= 0, by repeated squaring where the exponent is a whole number from 0 to 64
/// (a few multiplications instead of a call of std::pow), else by std::pow.
MORAINE_HD inline double power(double x, double exponent) {
  if (!(exponent >= 0.0 && exponent <= 64.0)) return std::pow(x, exponent);
  auto remaining = static_cast<unsigned>(exponent);
  if (static_cast<double>(remaining) != exponent) return std::pow(x, exponent);
  double result = 1.0;
  for (double square = x; remaining != 0; remaining >>= 1, square *= square)
    if ((remaining & 1U) != 0) result *= square;
  return result;
}

}  // namespace moraine
