// Spherical charges in free air.
#include <fmt/format.h>

#include <array>

#include "blast/free_air.hpp"
#include "blast/kingery_bulmash.hpp"
#include "blast/sources.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

constexpr Topic topic = Topic::air;
constexpr Burst burst = Burst::free_air;
constexpr Standing recommended = Standing::recommended, comparison = Standing::comparison,
                   doubtful = Standing::doubtful;

constexpr Validity kingery = scaled_imperial(0.134, 100.0);
constexpr std::string_view polynomial = "log10 Y = sum c_i (U_0 + U_1 log10 Z)^i";
constexpr std::string_view shape_note =
    "as printed the fits of shapes differ fivefold, the signs of 1/Z^2 are in doubt";

double incident(Situation const& s) {
  return s.explosive_factor * kingery_overpressure(burst, s.scaled_distance());
}

/// What the front of Kingery-Bulmash does in an ideal gas.
template <class Law>
Outcome ideal(Situation const& s, Law const& law) {
  constexpr double most = 40.0;
  double const strength = incident(s) / s.air.pressure;
  Outcome outcome = law(incident(s));
  if (strength <= most) return outcome;
  return std::move(outcome).outside(
      fmt::format("p/p_a is {:.3g}: above {:.0f} air is no ideal gas", strength, most));
}

constexpr Validity brode_range = range_of(
    "p", "bar", [](Situation const& s) { return brode_overpressure(s.scaled_distance()) / bar; },
    0.1, unbounded);

Outcome brode(Situation const& s) {
  Outcome outcome = s.explosive_factor * brode_overpressure(s.scaled_distance());
  double const z = s.scaled_distance();
  double const near = 6.7 / (z * z * z) + 1.0;
  bool const gap = near < 10.0 && brode_overpressure(z) > 10.0 * bar;
  return gap ? std::move(outcome).outside("between its two pieces, of which neither holds here")
             : outcome;
}

template <ShapeFit const& fit>
Outcome shape(Situation const& s) {
  return s.explosive_factor * shape_fit_overpressure(fit, s.scaled_distance());
}

constexpr Relation shape_relation(std::string_view name, std::string_view formula,
                                  Outcome (*evaluate)(Situation const&)) {
  return {.name = name,
          .topic = topic,
          .measure = Measure::peak_overpressure,
          .standing = doubtful,
          .formula = formula,
          .source = thesis_source,
          .note = shape_note,
          .validity = unstated,
          .sea_level_air = true,
          .evaluate = evaluate};
}

constexpr Relation kingery_relation(Measure measure, Validity const& validity,
                                    Outcome (*evaluate)(Situation const&)) {
  return {.name = "kingery_bulmash",
          .topic = topic,
          .measure = measure,
          .standing = recommended,
          .formula = polynomial,
          .source = kingery_source,
          .validity = validity,
          .sea_level_air = true,
          .evaluate = evaluate};
}

constexpr Relation front_relation(Measure measure, std::string_view formula,
                                  Outcome (*evaluate)(Situation const&)) {
  return {.name = "rankine_hugoniot",
          .topic = topic,
          .measure = measure,
          .standing = recommended,
          .formula = formula,
          .source = rankine_source,
          .note = "with the peak of Kingery-Bulmash",
          .validity = kingery,
          .sea_level_air = true,
          .evaluate = evaluate};
}

constexpr std::array list{
    kingery_relation(Measure::peak_overpressure, kingery,
                     [](Situation const& s) -> Outcome { return incident(s); }),
    Relation{
        .name = "kinney_graham",
        .topic = topic,
        .measure = Measure::peak_overpressure,
        .standing = recommended,
        .formula = "p/p_a = 808 [1+(Z/4.5)^2]/sqrt{[1+(Z/.048)^2][1+(Z/.32)^2][1+(Z/1.35)^2]}",
        .source = kinney_source,
        .note = "within 11 % of Kingery-Bulmash up to Z = 10, 23 % above at the end of this range",
        .validity = scaled_metric(0.0532, 39.6),
        .evaluate = [](Situation const& s) -> Outcome {
          return s.explosive_factor *
                 kinney_graham_overpressure(s.scaled_distance(), s.air.pressure);
        }},
    Relation{.name = "brode",
             .topic = topic,
             .measure = Measure::peak_overpressure,
             .standing = comparison,
             .formula = "p = 6.7/Z^3 + 1 bar above 10, .975/Z + 1.455/Z^2 + 5.85/Z^3 - .019 below",
             .source = "H. L. Brode, J. Appl. Phys. 26 (1955) 766",
             .note = "a point source: far too high near the charge",
             .validity = brode_range,
             .sea_level_air = true,
             .evaluate = brode},
    Relation{.name = "henrych",
             .topic = topic,
             .measure = Measure::peak_overpressure,
             .standing = comparison,
             .formula = "p = a/Z + b/Z^2 + c/Z^3 + d/Z^4 kgf/cm^2 in three pieces",
             .source = "J. Henrych, The Dynamics of Explosion and its Use (1979), ch. 4",
             .validity = scaled_metric(0.05, 10.0),
             .sea_level_air = true,
             .evaluate = [](Situation const& s) -> Outcome {
               return s.explosive_factor * henrych_overpressure(s.scaled_distance());
             }},
    Relation{.name = "thesis_fit",
             .topic = topic,
             .measure = Measure::peak_overpressure,
             .standing = comparison,
             .formula = "p = 4120/Z^3 - 105/Z^2 + 39.5/Z psi",
             .source = thesis_source,
             .validity = scaled_imperial(3.0, 20.0),
             .sea_level_air = true,
             .evaluate = [](Situation const& s) -> Outcome {
               return s.explosive_factor * thesis_overpressure(s.scaled_distance());
             }},
    shape_relation("tnt_block_1_lb", "p = 36280/Z^3 - 770/Z^2 + 13.5/Z psi", shape<tnt_block_1_lb>),
    shape_relation("pentolite_cylinder_8_lb", "p = 21070/Z^3 - 135/Z^2 + 10.5/Z psi",
                   shape<pentolite_cylinder_8_lb>),
    shape_relation("tnt_cylinder_4_lb", "p = 19210/Z^3 - 186/Z^2 + 11.34/Z psi",
                   shape<tnt_cylinder_4_lb>),
    shape_relation("pentolite_sphere_3.75_lb", "p = 7823/Z^3 - 295/Z^2 + 8.63/Z psi",
                   shape<pentolite_sphere_3_75_lb>),
    kingery_relation(Measure::reflected_overpressure, kingery,
                     [](Situation const& s) -> Outcome {
                       return s.explosive_factor *
                              kingery_reflected_overpressure(burst, s.scaled_distance());
                     }),
    front_relation(Measure::reflected_overpressure, "p_r = 2p (7p_a + 4p)/(7p_a + p)",
                   [](Situation const& s) {
                     return ideal(s,
                                  [&](double p) { return normal_reflection(p, s.air.pressure); });
                   }),
    front_relation(Measure::dynamic_pressure, "q = 2.5 p^2/(7p_a + p)",
                   [](Situation const& s) {
                     return ideal(s, [&](double p) { return dynamic_pressure(p, s.air); });
                   }),
    kingery_relation(Measure::impulse, kingery,
                     [](Situation const& s) -> Outcome {
                       return s.explosive_factor * s.size() *
                              kingery_impulse(burst, s.scaled_distance());
                     }),
    kingery_relation(Measure::reflected_impulse, kingery,
                     [](Situation const& s) -> Outcome {
                       return s.explosive_factor * s.size() *
                              kingery_reflected_impulse(burst, s.scaled_distance());
                     }),
    kingery_relation(Measure::arrival_time, kingery,
                     [](Situation const& s) -> Outcome {
                       return s.size() * kingery_arrival_time(burst, s.scaled_distance());
                     }),
    kingery_relation(Measure::positive_duration, scaled_imperial(0.37, 100.0),
                     [](Situation const& s) -> Outcome {
                       return s.size() * kingery_duration(burst, s.scaled_distance());
                     }),
    Relation{
        .name = "kinney_graham",
        .topic = topic,
        .measure = Measure::positive_duration,
        .standing = comparison,
        .formula = "t/W^(1/3) = 980 [1+(Z/.54)^10]/{[1+(Z/.02)^3][1+(Z/.74)^6]sqrt[1+(Z/6.9)^2]}",
        .source = kinney_source,
        .note = "17 to 71 % below Kingery-Bulmash for Z of 1 to 10; not compared elsewhere",
        .validity = scaled_metric(1.0, 10.0),
        .sea_level_air = true,
        .evaluate = [](Situation const& s) -> Outcome {
          return s.size() * kinney_graham_duration(s.scaled_distance());
        }},
    front_relation(Measure::front_speed, "U = c sqrt(1 + 6p/7p_a)",
                   [](Situation const& s) {
                     return ideal(s, [&](double p) { return front_speed(p, s.air); });
                   }),
    front_relation(Measure::particle_speed, "u = c (5p/7p_a)/sqrt(1 + 6p/7p_a)",
                   [](Situation const& s) {
                     return ideal(s, [&](double p) { return particle_speed(p, s.air); });
                   }),
};

}  // namespace

std::span<Relation const> air_relations() { return list; }

}  // namespace moraine::blast
