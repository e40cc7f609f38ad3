#include "exact/compaction.hpp"

#include <algorithm>
#include <stdexcept>

namespace moraine {

Law law_of_loaded(Eos const& eos, double rho, double e) {
  if (auto const* porous = std::get_if<PAlpha>(&eos))
    return Compacted{*porous, porous->virgin(rho, e).distension};
  return eos;
}

CompactionWaves waves_from_piston(PAlpha const& material, double rho, double e,
                                  double piston_velocity) {
  double const u = piston_velocity;
  ShockWave const single{shock_from_piston(material, rho, e, u), u};
  double const limit = material.elastic_limit;
  if (single.behind.pressure <= limit || material.pressure(rho, e) >= limit) return {{}, single};
  ShockWave const precursor = shock_to_pressure(material, rho, e, limit);
  ShockState const& elastic = precursor.behind;
  if (single.behind.shock_speed >= elastic.shock_speed) return {{}, single};
  double const pushed = precursor.piston_velocity;
  ShockWave main{shock_from_piston(material, elastic.density, elastic.specific_energy, u - pushed),
                 u};
  main.behind.shock_speed += pushed;
  return {precursor, main};
}

std::vector<ShockWave> compaction_curve(PAlpha const& material, double rho, double e,
                                        double fastest_piston, int count) {
  std::vector<ShockWave> curve;
  for (int k = 0; k < count; ++k) {
    try {
      curve.push_back(
          waves_from_piston(material, rho, e, fastest_piston * k / std::max(count - 1, 1)).main);
    } catch (std::domain_error const&) {
      break;
    }
  }
  return curve;
}

}  // namespace moraine
