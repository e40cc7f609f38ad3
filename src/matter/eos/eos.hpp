// The closed list of equations of state. Adding one: its header, one entry in `Eos`, one test, one
// section in docs/theory/matter.md.
#pragma once

#include <limits>
#include <string_view>
#include <type_traits>
#include <variant>

#include "matter/eos/ideal_gas.hpp"
#include "matter/eos/jwl.hpp"
#include "matter/eos/linear.hpp"
#include "matter/eos/mie_grueneisen.hpp"
#include "matter/eos/tait.hpp"
#include "matter/eos/us_up.hpp"
#include "matter/eos/water_polynomial.hpp"

namespace moraine {

/// Visited once per material and pass, outside the loop over particles.
using Eos = std::variant<Tait, WaterPolynomial, Jwl, IdealGas, MieGrueneisen, UsUp, Linear>;

/// Whether a law can be that of the products of an explosive that burns by and by.
template <class Law>
inline constexpr bool is_products = requires(Law const& law, double rho) {
  law.pressure_by_energy(rho);
};

inline bool can_burn(Eos const& eos) {
  return std::visit([](auto const& law) { return is_products<std::decay_t<decltype(law)>>; }, eos);
}

/// Density in the undisturbed state [kg/m^3].
inline double reference_density(Eos const& eos) {
  return std::visit([](auto const& law) { return law.reference_density; }, eos);
}

/// Specific energy in the undisturbed state [J/kg].
inline double reference_energy(Eos const& eos) {
  return std::visit([](auto const& law) { return law.reference_energy; }, eos);
}

/// Density that the law cannot reach [kg/m^3]; infinite for most.
inline double limiting_density(Eos const& eos) {
  UsUp const* const law = std::get_if<UsUp>(&eos);
  return law != nullptr ? law->limiting_density() : std::numeric_limits<double>::infinity();
}

/// Name in case files.
inline std::string_view eos_name(Eos const& eos) {
  return std::visit([](auto const& law) { return std::string_view(law.name); }, eos);
}

}  // namespace moraine
