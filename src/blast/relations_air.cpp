// Spherical charges in free air.
#include <array>

#include "blast/free_air.hpp"
#include "blast/kingery_relations.hpp"
#include "blast/sources.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

constexpr Topic topic = Topic::air;
constexpr Standing comparison = Standing::comparison;

constexpr std::string_view shape_note =
    "as printed the fits of shapes differ fivefold, the signs of 1/Z^2 are in doubt";

/// Where a sphere of air at sea level weighs as much as the charge in its middle [m/kg^(1/3)].
constexpr double least_point_source_distance = 0.58;

constexpr Validity brode_range = range_of(
    "p", "bar", [](Situation const& s) { return brode_overpressure(s.scaled_distance()) / bar; },
    0.1, unbounded);

Outcome brode(Situation const& s) {
  Outcome outcome = s.explosive_factor * brode_overpressure(s.scaled_distance());
  double const z = s.scaled_distance();
  double const near = 6.7 / (z * z * z) + 1.0;
  if (near < 10.0 && brode_overpressure(z) > 10.0 * bar)
    return std::move(outcome).outside("between its two pieces, of which neither holds here");
  if (z < least_point_source_distance)
    return std::move(outcome).outside("a point source, but the charge outweighs the swept air");
  return outcome;
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
          .standing = Standing::doubtful,
          .formula = formula,
          .source = thesis_source,
          .note = shape_note,
          .validity = unstated,
          .sea_level_air = true,
          .evaluate = evaluate};
}

constexpr std::array list{
    Relation{
        .name = "kinney_graham",
        .topic = topic,
        .measure = Measure::peak_overpressure,
        .standing = Standing::recommended,
        .formula = "p/p_a = 808 [1+(Z/4.5)^2]/sqrt{[1+(Z/.048)^2][1+(Z/.32)^2][1+(Z/1.35)^2]}",
        .source = kinney_source,
        .note = "within 11 % of Kingery-Bulmash up to Z = 10, 23 % above at the end of this range",
        .validity = scaled_metric(0.0532, 39.6),
        .sea_level_air = true,
        .evaluate = [](Situation const& s) -> Outcome {
          return s.explosive_factor *
                 kinney_graham_overpressure(s.scaled_distance(), s.air.pressure);
        }},
    Relation{
        .name = "brode",
        .topic = topic,
        .measure = Measure::peak_overpressure,
        .standing = comparison,
        .formula = "p = 6.7/Z^3 + 1 bar above 10, .975/Z + 1.455/Z^2 + 5.85/Z^3 - .019 below",
        .source = "H. L. Brode, J. Appl. Phys. 26 (1955) 766",
        .note = "a point source: far too high near the charge, below R/W^(1/3) of .58 m/kg^(1/3)",
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
    Relation{.name = "three_term_fit",
             .topic = topic,
             .measure = Measure::peak_overpressure,
             .standing = comparison,
             .formula = "p = 4120/Z^3 - 105/Z^2 + 39.5/Z psi",
             .source = thesis_source,
             .validity = scaled_imperial(3.0, 20.0),
             .sea_level_air = true,
             .evaluate = [](Situation const& s) -> Outcome {
               return s.explosive_factor * three_term_overpressure(s.scaled_distance());
             }},
    shape_relation("tnt_block_1_lb", "p = 36280/Z^3 - 770/Z^2 + 13.5/Z psi", shape<tnt_block_1_lb>),
    shape_relation("pentolite_cylinder_8_lb", "p = 21070/Z^3 - 135/Z^2 + 10.5/Z psi",
                   shape<pentolite_cylinder_8_lb>),
    shape_relation("tnt_cylinder_4_lb", "p = 19210/Z^3 - 186/Z^2 + 11.34/Z psi",
                   shape<tnt_cylinder_4_lb>),
    shape_relation("pentolite_sphere_3.75_lb", "p = 7823/Z^3 - 295/Z^2 + 8.63/Z psi",
                   shape<pentolite_sphere_3_75_lb>),
    Relation{
        .name = "kinney_graham",
        .topic = topic,
        .measure = Measure::positive_duration,
        .standing = comparison,
        .formula = "t/W^(1/3) = 980 [1+(Z/.54)^10]/{[1+(Z/.02)^3][1+(Z/.74)^6]sqrt[1+(Z/6.9)^2]}",
        .source = kinney_source,
        .note = "17 to 71 % below Kingery-Bulmash for Z of 1 to 10, which is this range",
        .validity = scaled_metric(1.0, 10.0),
        .sea_level_air = true,
        .evaluate = [](Situation const& s) -> Outcome {
          return s.size() * kinney_graham_duration(s.scaled_distance());
        }},
};

}  // namespace

std::span<Relation const> air_relations() { return list; }

std::span<Relation const> kingery_air_relations() {
  static constexpr auto kingery = kingery_relations<Burst::free_air>(topic);
  return kingery;
}

}  // namespace moraine::blast
