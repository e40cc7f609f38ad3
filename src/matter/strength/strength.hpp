// The closed list of strength laws. Adding one: its header, one entry in `Strength`, its keys in
// setup/strength_table.cpp, one test, one section in docs/theory/strength.md.
//
// A law is an aggregate of its constants with these members, all usable on a device:
//   name             as written in case files
//   shear_modulus    G [Pa]
//   limit(s, p)      the stress that the material bears in place of the deviatoric stress s at the
//                    pressure p [Pa]
// Nothing here throws; a stress that is no number stays one.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "matter/strength/drucker_prager.hpp"
#include "matter/strength/elastic.hpp"
#include "matter/strength/mohr_coulomb.hpp"
#include "matter/strength/stress_update.hpp"
#include "matter/strength/von_mises.hpp"

namespace moraine {

/// A fluid.
struct NoStrength {
  static constexpr char const* name = "none";
};

/// Visited once per material and pass, outside the loop over particles.
using Strength = std::variant<NoStrength, Elastic, VonMises, DruckerPrager, MohrCoulomb>;

/// Names in case files, in the order of the list.
inline constexpr std::array<std::string_view, 5> strength_names{
    NoStrength::name, Elastic::name, VonMises::name, DruckerPrager::name, MohrCoulomb::name};

inline bool is_solid(Strength const& strength) {
  return !std::holds_alternative<NoStrength>(strength);
}

/// G [Pa]; zero of a fluid.
inline double shear_modulus(Strength const& strength) {
  return std::visit(
      [](auto const& law) {
        if constexpr (requires { law.shear_modulus; })
          return law.shear_modulus;
        else
          return 0.0;
      },
      strength);
}

/// Name in case files.
inline std::string_view strength_name(Strength const& strength) {
  return strength_names[strength.index()];
}

}  // namespace moraine
