// Reading values with units: "4 cm" -> 0.04. Inside the program everything is in SI units.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace moraine {

/// The kinds of physical quantity that a case file can hold.
enum class Quantity : std::uint8_t {
  number,
  length,
  time,
  velocity,
  acceleration,
  density,
  pressure,
  specific_energy,
  mass,
  angle,
  angular_velocity,
  frequency,
  dynamic_viscosity,
};
inline constexpr std::size_t quantity_count = 13;

/// What messages and the reference page say about a quantity.
struct QuantityInfo {
  Quantity quantity;
  std::string_view name;                  // with its article, for messages
  std::string_view unit;                  // SI, in the notation of UDUNITS-2
  std::array<std::string_view, 6> usual;  // units to suggest, empty entries at the end
};

/// The entry of the table of quantities. Never fails.
QuantityInfo const& info(Quantity quantity);

/// A dimension that case files do not hold: an impulse per area, an energy per area.
struct Dimension {
  std::string_view name;                  // with its article, for messages
  std::string_view unit;                  // SI, in the notation of UDUNITS-2
  std::array<std::string_view, 6> usual;  // units to suggest, empty entries at the end
};

/// A value in SI units, or why there is none. `rule` continues a sentence that starts with the
/// value ("is a mass; a density is expected (kg/m^3)"); `hint` may be empty.
struct Conversion {
  std::optional<double> value;
  std::string rule;
  std::string hint;
};

/// Reads a number followed by a unit and converts it to SI.
///
/// The unit is anything UDUNITS-2 knows, and the aliases `g0` (standard gravity, 9.80665 m/s^2) and
/// `deg` (degree). Both signs for micro and the letter u are understood. The unit must have exactly
/// the dimension of `expected`: reciprocals, offsets (degC) and logarithmic units are refused, and
/// a plain number counts only as Quantity::number. A finite value is returned correctly rounded
/// for units that are a whole fraction of the SI unit ("9 mm" is the double nearest to 0.009).
/// Never throws for bad text and prints nothing. Calls are serialised (UDUNITS-2 is not reentrant).
Conversion to_si(std::string_view text, Quantity expected);

/// The same for any other dimension.
Conversion to_si(std::string_view text, Dimension const& expected);

}  // namespace moraine
