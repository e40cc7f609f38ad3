// Numbers and units as people read them.
#pragma once

#include <string>
#include <string_view>

namespace moraine {

/// A scale for numbers of one quantity: shown number = value / factor, with the unit `unit`.
struct DisplayUnit {
  double factor = 1.0;
  std::string unit;
};

/// The unit in which a quantity of size `largest` (in `unit`) reads well: an SI prefix from nano to
/// tera that brings `largest` into [1, 1000) where the unit takes one ("Pa", "m/s", "J/kg", "s"),
/// otherwise a power of ten as in "10³ kg/m³" for very large or small numbers. Seconds get no
/// prefix above one, lengths are in µm, mm, cm, m or km, and velocities and accelerations between
/// 0.01 and 10 000 stay as they are. Powers are typeset: "m^2" becomes "m²".
DisplayUnit display_unit(std::string_view unit, double largest);

/// "kPa·ms" for "kPa ms", "m³" for "m^3", "µs" for "us".
std::string typeset_unit(std::string_view unit);

/// "10⁻⁵".
std::string power_of_ten(int exponent);

/// "1.23 ms": a value with its display unit and `digits` significant digits.
std::string with_unit(double value, std::string_view unit, int digits = 3);

/// "84.2 M": a plain number with an SI prefix and three significant digits.
std::string with_prefix(double value);

}  // namespace moraine
