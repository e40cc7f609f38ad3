// Plane waves in porous material that is compacted.
#pragma once

#include <optional>
#include <vector>

#include "exact/hugoniot.hpp"
#include "exact/law.hpp"
#include "matter/eos/p_alpha.hpp"

namespace moraine {

/// Material that has been compacted down to a distension: a law of density and energy like any
/// other, that unloads along the elastic line from there.
struct Compacted {
  PAlpha material;
  double distension;  // -, the least that has been reached

  double pressure(double rho, double e) const {
    return material.respond(rho, e, distension).pressure;
  }
  double sound_speed_squared(double rho, double e) const {
    return material.respond(rho, e, distension).sound_speed_squared;
  }
};

/// The law of material that undisturbed has been loaded to density `rho` [kg/m^3] and energy `e`
/// [J/kg]: with the memory of that where it has one.
Law law_of_loaded(Eos const& eos, double rho, double e);

/// What runs ahead of a piston into porous material at rest.
struct CompactionWaves {
  std::optional<ShockWave> precursor;  // elastic, up to the elastic limit
  ShockWave main;                      // speeds over the undisturbed material
};

/// Waves ahead of a piston of `piston_velocity` u [m/s], the material undisturbed with density
/// `rho` and energy `e`.
///
/// Up to the elastic limit p_e there is one elastic shock. Beyond, compaction runs behind an
/// elastic precursor to p_e, as long as it is slower than that; each is a shock by the jump
/// conditions (exact/hugoniot.hpp), the second into the material behind the first. From where
/// compaction is as fast there is one shock only. Source: Herrmann, J. Appl. Phys. 40 (1969) 2490;
/// Zel'dovich and Raizer, Physics of Shock Waves (1966), chapter XI, sections 18 and 19. Range: as
/// shock_from_piston. Crush curves on which p rises ever faster with the density, as those of
/// p_alpha do, so that compaction is steady.
CompactionWaves waves_from_piston(PAlpha const& material, double rho, double e,
                                  double piston_velocity);

/// The main waves of `count` equidistant piston velocities up to `fastest_piston`, the first of
/// them sound. Ends before the first for which the law has none.
std::vector<ShockWave> compaction_curve(PAlpha const& material, double rho, double e,
                                        double fastest_piston, int count);

}  // namespace moraine
