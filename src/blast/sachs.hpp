// Relations measured in air at sea level, carried over to other air.
#pragma once

#include "blast/measure.hpp"
#include "blast/situation.hpp"

namespace moraine::blast {

/// The same place and energy in standard air, seen with the ambient pressure p_a as the unit of
/// pressure: a charge of W p_0/p_a, p_0 = 101.325 kPa.
///
/// Sachs' scaling: for an ideal gas p/p_a, t c_a/R and u/c_a depend on R (p_a/E)^(1/3) alone, so a
/// relation for standard air holds in other air for this charge, its results times sachs_factor.
/// Source: R. G. Sachs, The dependence of blast on ambient pressure and temperature, BRL 466
/// (1944).
Situation at_sea_level(Situation const& situation);

/// What such a result is multiplied with: p_a/p_0 for pressures, c_0/c_a for times, c_a/c_0 for
/// speeds, p_a c_0/(p_0 c_a) for impulses per area, 1 for others; c the speeds of sound.
double sachs_factor(Kind kind, Air const& air);

/// What a result that was carried over says of itself.
inline constexpr std::string_view sachs_caution =
    "measured in air at sea level, 101.325 kPa and 1.225 kg/m^3: carried over by Sachs' scaling, "
    "its range too";

}  // namespace moraine::blast
