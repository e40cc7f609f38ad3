// The closed list of equations of state. Adding one: its header, one entry in `Eos`, one test, one
// section in docs/theory/matter.md.
#pragma once

#include <string_view>
#include <variant>

#include "matter/eos/ideal_gas.hpp"
#include "matter/eos/jwl.hpp"
#include "matter/eos/tait.hpp"
#include "matter/eos/water_polynomial.hpp"

namespace moraine {

/// Visited once per material and pass, outside the loop over particles.
using Eos = std::variant<Tait, WaterPolynomial, Jwl, IdealGas>;

/// Density in the undisturbed state [kg/m^3].
inline double reference_density(Eos const& eos) {
  return std::visit([](auto const& law) { return law.reference_density; }, eos);
}

/// Specific energy in the undisturbed state [J/kg].
inline double reference_energy(Eos const& eos) {
  return std::visit([](auto const& law) { return law.reference_energy; }, eos);
}

/// Name in case files.
inline std::string_view eos_name(Eos const& eos) {
  return std::visit([](auto const& law) { return std::string_view(law.name); }, eos);
}

}  // namespace moraine
