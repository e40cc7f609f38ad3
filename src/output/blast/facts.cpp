#include "output/blast/facts.hpp"

#include <fmt/core.h>

#include <cmath>

#include "blast/line_charge.hpp"
#include "blast/underwater.hpp"
#include "output/blast/output_units.hpp"

namespace moraine::blast {
namespace {

std::string_view name_of(CraterType type) {
  switch (type) {
    case CraterType::scour:
      return "a scour: the charge sticks out of the ground";
    case CraterType::throw_out:
      return "a crater thrown out: the charge breaks the ground above it";
    case CraterType::camouflet:
      break;
  }
  return "a camouflet: the rupture radius does not reach the surface";
}

std::string pressure(double pascal, UnitSystem system) {
  bool const imperial = system == UnitSystem::imperial;
  return imperial ? readable(pascal / psi) + " psi" : readable(pascal / 1e3) + " kPa";
}

}  // namespace

std::vector<std::string> facts(Topic topic, Situation const& s, UnitSystem system) {
  std::vector<std::string> lines;
  if (s.explosive_factor != 1.0)
    lines.push_back(fmt::format("factor of the explosive on pressures and impulses: {}",
                                readable(s.explosive_factor)));
  if (std::isfinite(s.charge_mass))
    lines.push_back(fmt::format("TNT that scales distances: {} kg or {} lb",
                                readable(s.charge_mass), readable(s.charge_mass / pound)));
  if (topic == Topic::line)
    lines.push_back(
        fmt::format("R sqrt(L/W) is {} m/sqrt(kg/m), R/R_0 is {}",
                    readable(line_scaled_distance(s.charge_mass, s.length, s.distance)),
                    readable(s.distance / sachs_length(Source::line, tnt_energy * s.charge_mass,
                                                       s.length, s.air.pressure))));
  else if (std::isfinite(s.scaled_distance()))
    lines.push_back(fmt::format("R/W^(1/3) is {} m/kg^(1/3) or {} ft/lb^(1/3)",
                                readable(s.scaled_distance()),
                                readable(s.scaled_distance_imperial())));
  if (topic == Topic::water)
    lines.push_back(
        fmt::format("{} charge radii away", readable(charge_radii(s.scaled_distance()))));
  if (topic == Topic::reflection || topic == Topic::pulse)
    lines.push_back(fmt::format("overpressure {}, {} times the ambient pressure",
                                pressure(s.overpressure, system),
                                readable(s.overpressure / s.air.pressure)));
  if (topic == Topic::pulse) {
    lines.push_back(fmt::format("duration {} ms", readable(s.duration * 1e3)));
    if (std::isfinite(s.decay)) lines.push_back(fmt::format("decay {}", readable(s.decay)));
  }
  if (topic == Topic::buried) lines.push_back(fmt::format("coupling {}", readable(s.coupling)));
  if (topic == Topic::bubble)
    lines.push_back(
        fmt::format("pressure of the water {}", pressure(s.water.pressure(s.depth), system)));
  if (topic == Topic::crater && s.broken != nullptr && std::isfinite(s.depth))
    lines.emplace_back(name_of(crater_type(s.charge_mass, s.depth, s.broken->low)));
  return lines;
}

}  // namespace moraine::blast
