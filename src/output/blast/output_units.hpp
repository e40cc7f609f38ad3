// Units in which results are shown, and numbers as people read them.
#pragma once

#include <array>
#include <string>

#include "blast/measure.hpp"

namespace moraine::blast {

/// A system of units, with a unit of its own for some kinds of quantity.
struct OutputUnits {
  UnitSystem system = UnitSystem::metric;
  std::array<std::string, kind_count> chosen;  // by Kind; empty: of the system

  /// Unit of a measure, "1" for plain numbers.
  std::string unit(Measure measure) const;
  /// A value in SI in that unit.
  double shown(Measure measure, double value) const;
};

/// Four significant digits, without an exponent from 0.001 to below a million: "0.01234", "123400".
std::string readable(double value);

/// "peak overpressure" of "peak_overpressure".
std::string words(std::string_view name);

/// "peak overpressure (kPa)", without the brackets for plain numbers.
std::string with_unit(std::string_view name, std::string_view unit);

}  // namespace moraine::blast
