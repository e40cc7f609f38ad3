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
#include "matter/eos/p_alpha.hpp"
#include "matter/eos/tait.hpp"
#include "matter/eos/us_up.hpp"
#include "matter/eos/water_polynomial.hpp"

namespace moraine {

/// Visited once per material and pass, outside the loop over particles.
using Eos = std::variant<Tait, WaterPolynomial, Jwl, IdealGas, MieGrueneisen, UsUp, Linear, PAlpha>;

/// Whether a law can be that of the products of an explosive that burns by and by.
template <class Law>
inline constexpr bool is_products = requires(Law const& law, double rho) {
  law.pressure_by_energy(rho);
};

inline bool can_burn(Eos const& eos) {
  return std::visit([](auto const& law) { return is_products<std::decay_t<decltype(law)>>; }, eos);
}

/// Whether particles of a law remember how far they have been compacted.
template <class Law>
inline constexpr bool is_compactable = requires(Law const& law) {
  law.virgin_distension();
};

inline bool can_compact(Eos const& eos) {
  return std::visit([](auto const& law) { return is_compactable<std::decay_t<decltype(law)>>; },
                    eos);
}

/// What particles remember that have never been compacted; 1 for material without pores.
inline double virgin_distension(Eos const& eos) {
  return std::visit(
      [](auto const& law) {
        if constexpr (is_compactable<std::decay_t<decltype(law)>>)
          return law.virgin_distension();
        else
          return 1.0;
      },
      eos);
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
  return std::visit(
      [](auto const& law) {
        if constexpr (requires { law.limiting_density(); })
          return law.limiting_density();
        else
          return std::numeric_limits<double>::infinity();
      },
      eos);
}

/// Name in case files.
inline std::string_view eos_name(Eos const& eos) {
  return std::visit([](auto const& law) { return std::string_view(law.name); }, eos);
}

}  // namespace moraine
