// Reflection of a front at a rigid wall.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <numbers>

#include "blast/oblique_reflection.hpp"
#include "blast/sources.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

constexpr Topic topic = Topic::reflection;
constexpr double degree = std::numbers::pi / 180.0;

double strength(Situation const& s) { return s.overpressure / s.air.pressure; }
bool has_angle(Situation const& s) { return !std::isnan(s.angle); }

constexpr Validity ideal_air = range_of("p/p_a", "", strength, 0.0, 40.0);
constexpr Validity strong = range_of("p/p_a", "", strength, 1.0, 40.0);
constexpr std::string_view two_shock_source =
    "J. von Neumann, Oblique reflection of shocks (1943): two-shock theory";
constexpr std::string_view three_shock_source =
    "J. von Neumann, Oblique reflection of shocks (1943): three-shock theory";

double limit(Situation const& s) { return extreme_angle(s.overpressure, s.air.pressure); }

Outcome regular(Situation const& s) {
  if (auto const p = regular_reflection(s.overpressure, s.air.pressure, s.angle)) return *p;
  return Outcome::none(
      fmt::format("no regular reflection above {:.2f} degrees at this pressure: a Mach stem forms",
                  limit(s) / degree));
}

/// The stem, or why there is none.
template <class Part>
Outcome stem(Situation const& s, Part const& part) {
  if (s.angle <= limit(s))
    return Outcome::none(
        fmt::format("no Mach stem up to {:.2f} degrees: reflection is regular", limit(s) / degree));
  if (auto const found = mach_reflection(s.overpressure, s.air.pressure, s.angle))
    return part(*found);
  return Outcome::none("three-shock theory has no solution here, though a stem forms");
}

constexpr std::array list{
    Relation{.name = "normal",
             .topic = topic,
             .measure = Measure::reflected_overpressure,
             .standing = Standing::recommended,
             .formula = "p_r = 2p (7p_a + 4p)/(7p_a + p)",
             .source = rankine_source,
             .validity = ideal_air,
             .applies = [](Situation const& s) { return !has_angle(s); },
             .evaluate = [](Situation const& s) -> Outcome {
               return normal_reflection(s.overpressure, s.air.pressure);
             }},
    Relation{.name = "two_shock",
             .topic = topic,
             .measure = Measure::reflected_overpressure,
             .standing = Standing::recommended,
             .formula = "the reflected front turns the stream back: theta_2(p_r) = theta_1(p)",
             .source = two_shock_source,
             .validity = ideal_air,
             .needs = "an angle",
             .applies = has_angle,
             .evaluate = regular},
    Relation{.name = "three_shock",
             .topic = topic,
             .measure = Measure::stem_overpressure,
             .standing = Standing::comparison,
             .formula = "theta_1 - theta_2 = theta_3 at equal pressure, stem normal to the wall",
             .source = three_shock_source,
             .validity = strong,
             .needs = "an angle",
             .applies = has_angle,
             .evaluate =
                 [](Situation const& s) {
                   return stem(s, [](MachStem const& m) { return m.overpressure; });
                 }},
    Relation{.name = "rankine_hugoniot",
             .topic = topic,
             .measure = Measure::dynamic_pressure,
             .standing = Standing::recommended,
             .formula = "q = 2.5 p^2/(7p_a + p)",
             .source = rankine_source,
             .validity = ideal_air,
             .evaluate = [](Situation const& s) -> Outcome {
               return dynamic_pressure(s.overpressure, s.air);
             }},
    Relation{.name = "rankine_hugoniot",
             .topic = topic,
             .measure = Measure::front_speed,
             .standing = Standing::recommended,
             .formula = "U = c sqrt(1 + 6p/7p_a)",
             .source = rankine_source,
             .validity = ideal_air,
             .evaluate = [](Situation const& s) -> Outcome {
               return front_speed(s.overpressure, s.air);
             }},
    Relation{.name = "rankine_hugoniot",
             .topic = topic,
             .measure = Measure::particle_speed,
             .standing = Standing::recommended,
             .formula = "u = c (5p/7p_a)/sqrt(1 + 6p/7p_a)",
             .source = rankine_source,
             .validity = ideal_air,
             .evaluate = [](Situation const& s) -> Outcome {
               return particle_speed(s.overpressure, s.air);
             }},
    Relation{.name = "two_shock",
             .topic = topic,
             .measure = Measure::extreme_angle,
             .standing = Standing::recommended,
             .formula = "largest angle of regular reflection",
             .source = two_shock_source,
             .validity = ideal_air,
             .evaluate = [](Situation const& s) -> Outcome { return limit(s); }},
    Relation{.name = "three_shock",
             .topic = topic,
             .measure = Measure::path_angle,
             .standing = Standing::comparison,
             .formula = "between the wall and the path of the triple point",
             .source = three_shock_source,
             .validity = strong,
             .needs = "an angle",
             .applies = has_angle,
             .evaluate =
                 [](Situation const& s) {
                   return stem(s, [](MachStem const& m) { return m.path_angle; });
                 }},
};

}  // namespace

std::span<Relation const> reflection_relations() { return list; }

}  // namespace moraine::blast
